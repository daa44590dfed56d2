#pragma once
/// Ways to drive: straight lines and circular arcs, one after the other (C98 section III-B: "either a straight
/// line or a circular segment").

#include <cstddef>
#include <span>
#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/vehicle/arc.hpp"

namespace aisle {

/// One line or arc of a path. Driven backwards it has a negative length.
struct PathPiece {
  Pose2 T_map_start;
  Arc arc;  ///< as base_link drives it

  Pose2 at(double from_start_m) const;  ///< base_link after so much way along the piece, 0 .. |length|
};

/// A point on a path.
struct PathPoint {
  std::size_t piece = 0;
  double along_m = 0;  ///< way from the path's start, always growing, also backwards
  Pose2 T_map_path;    ///< base_link there
  double curvature_per_m = 0;  ///< left positive
  double aside_m = 0;          ///< how far the asked point is to the left of it
};

class Path {
 public:
  Path() = default;
  /// @param pieces  each starts where the one before ends
  explicit Path(std::vector<PathPiece> pieces);

  const std::vector<PathPiece>& pieces() const { return pieces_; }
  double length_m() const { return length_m_; }
  bool empty() const { return pieces_.empty(); }

  /// @param along_m  0 .. length_m(), else the nearer end
  PathPoint at(double along_m) const;

  /// The nearest point among those from `from_m` to `to_m` along the path: a path that crosses itself is
  /// followed, not cut short.
  PathPoint nearest(const Vec2& p_map, double from_m, double to_m) const;

  /// The same way back: pieces in opposite order, the vehicle turned about, driven forwards again.
  Path reversed() const;

 private:
  std::vector<PathPiece> pieces_;
  std::vector<double> starts_m_;
  double length_m_ = 0;
};

struct PathFitParams {
  double stray_max_m = 0.03;      ///< what was driven is at most this far from the path
  double radius_min_m = 0.6;      ///< of an arc

  void describe(FieldList& fields);
};

/// Smooths a way as it was driven to few lines and arcs that join without a kink: hand-driven wander within
/// `stray_max_m` goes, corners stay. A stretch driven backwards becomes pieces of negative length.
/// @param driven  base_link in `map`, in order, at least two different positions
Path fit_path(std::span<const Pose2> driven, const PathFitParams& params);

}  // namespace aisle
