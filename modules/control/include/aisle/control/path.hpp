#pragma once
/// Paths to drive: straight lines and circular arcs, one after the other (C98 section III-B: "either a
/// straight line or a circular segment").

#include <cstddef>
#include <vector>

#include "aisle/geometry/pose2.hpp"
#include "aisle/vehicle/arc.hpp"

namespace aisle {

/// What a vehicle does between two stops: it drives either way, or turns on the spot to either side.
enum class LegDirection { kForward, kReverse, kLeft, kRight };

constexpr LegDirection direction_of(const Arc& arc) {
  if (arc.length_m == 0) return arc.turn_rad < 0 ? LegDirection::kRight : LegDirection::kLeft;
  return arc.length_m < 0 ? LegDirection::kReverse : LegDirection::kForward;
}

/// One line or arc of a path. Driven backwards it has a negative length; of a turn on the spot it is 0.
struct PathPiece {
  Pose2 T_map_start;
  Arc arc;  ///< as base_link drives it

  /// Distance driven along the piece, >= 0.
  double path_m() const { return arc.length_m < 0 ? -arc.length_m : arc.length_m; }
  bool is_on_the_spot() const { return arc.length_m == 0; }
  /// Left positive; 0 for a turn on the spot.
  double curvature_per_m() const { return is_on_the_spot() ? 0 : arc.turn_rad / arc.length_m; }

  /// base_link after this distance along the piece, 0 .. path_m(). On the spot: as at its start.
  Pose2 at(double from_start_m) const;
  Pose2 end() const { return T_map_start * end_pose(arc); }

  /// Distance from the piece's start to its point nearest to `p_map`, among those from `from_m` to `to_m`
  /// (0 .. path_m()); the first of equally near ones.
  double nearest(const Vec2& p_map, double from_m, double to_m) const;
};

/// A point on a path.
struct PathPoint {
  std::size_t piece = 0;
  double along_m = 0;          ///< distance from the path's start; grows when driving backwards, too
  Pose2 T_map_path;            ///< base_link there
  double curvature_per_m = 0;  ///< left positive
  double lateral_m = 0;        ///< of the query point, left positive; 0 without one
};

class Path {
 public:
  Path() = default;
  /// @param pieces  each starts where the one before ends, in position and heading; else
  /// std::invalid_argument
  explicit Path(std::vector<PathPiece> pieces);

  const std::vector<PathPiece>& pieces() const { return pieces_; }
  double length_m() const { return length_m_; }
  bool empty() const { return pieces_.empty(); }
  /// Distance from the path's start to the start of a piece.
  double start_m(std::size_t piece) const { return starts_m_[piece]; }

  /// @param along_m  0 .. length_m(), else the nearer end. Where two pieces meet, the later one's start.
  PathPoint at(double along_m) const;
  /// Pose at the end, after a turn on the spot there; at(length_m()) is before it. The path must not be
  /// empty.
  Pose2 end() const { return pieces_.back().end(); }

  /// The nearest point among those from `from_m` to `to_m` along the path: a path that crosses itself is
  /// followed, not cut short. The first of equally near ones. The path must not be empty.
  PathPoint nearest(const Vec2& p_map, double from_m, double to_m) const {
    return nearest(p_map, from_m, to_m, 0, pieces_.size());
  }

  /// The nearest of those that also lie on the pieces `first` to before `end`; at least one piece must reach
  /// into the range.
  PathPoint nearest(const Vec2& p_map, double from_m, double to_m, std::size_t first, std::size_t end) const;

  /// The end of the leg that a piece belongs to: of the pieces that are driven without a stop between. A leg
  /// ends where the direction of driving changes; every turn on the spot is a leg of its own.
  /// @return index of the piece after it
  std::size_t leg_end(std::size_t piece) const;

  /// Distance from the path's start to the end of that leg.
  double leg_end_m(std::size_t piece) const;

  /// Its first `along_m`, at least 1 mm of it, with a turn on the spot there. The path must not be empty.
  Path up_to(double along_m) const { return up_to(along_m, pieces_.size()); }
  /// The same of the pieces before `end` only, of which there must be one.
  Path up_to(double along_m, std::size_t end) const;
  /// With another behind it, which must begin where this one ends.
  Path followed_by(const Path& next) const;

  /// The same path back to its start: pieces in opposite order, the vehicle turned about. What was driven
  /// forwards is driven forwards again.
  Path reversed() const;

 private:
  PathPoint point(std::size_t piece, double from_start_m) const;

  std::vector<PathPiece> pieces_;
  std::vector<double> starts_m_;
  double length_m_ = 0;
};

}  // namespace aisle
