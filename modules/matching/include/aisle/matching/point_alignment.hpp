#pragma once
/// Fits the points of a scan to points seen before, without knowing what they belong to: point to line.

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// A point on a surface and the surface's unit normal, which faces the sensor.
struct SurfacePoint {
  Vec2 p = Vec2::Zero();
  Vec2 normal = Vec2::UnitX();
};

/// The surface points of a scan, in the sensor's frame. A point's normal is that of the chord between its
/// neighbours; a point without neighbours on the same surface is left out, and so is one nearer than 2 cm to
/// the one before.
/// @param points  in the order of the beams, counter-clockwise
void surface_points(std::span<const Vec2> points, std::vector<SurfacePoint>& surface);

/// Surface points seen lately, found by their place.
class SurfaceMap {
 public:
  /// Adds a scan's points; a point within 2 cm of a known one adds nothing. Points that were added more than
  /// `kScansKept` additions ago are forgotten.
  void add(std::span<const SurfacePoint> surface, const Pose2& T_map_sensor);

  /// The nearest point within `reach_m` (up to kCell_m) whose normal agrees with `normal` to 45 degrees; null
  /// if there is none.
  const SurfacePoint* nearest(const Vec2& p_map, const Vec2& normal, double reach_m) const;
  bool empty() const { return cells_.empty(); }

  /// Calls `visit` with the centre of every cell of kNearCell_m that has a point of the map in it or beside
  /// it.
  template <class Visit>
  void for_each_near_cell(Visit visit) const {
    for (const auto& [cell, scan] : near_) {
      visit(kNearCell_m * Vec2(static_cast<double>(cell >> 32),
                               static_cast<double>(static_cast<std::int32_t>(cell & 0xffffffff))));
    }
  }

  static constexpr double kNearCell_m = 0.1;
  static constexpr double kCell_m = 0.3;
  static constexpr int kScansKept = 40;

 private:
  struct Kept {
    SurfacePoint point;
    int scan = 0;
  };
  static std::int64_t key(long column, long row);
  void forget_old();

  std::unordered_map<std::int64_t, std::vector<Kept>> cells_;
  std::unordered_map<std::int64_t, int> near_;  ///< cells of 10 cm beside a point -> scan that saw it last
  int scans_ = 0;
};

/// How a scan fits the map.
struct SurfaceFit {
  Pose2 T_map_sensor;
  double share = 0;                 ///< of the scan's points that lie on a surface of the map
  Mat3 information = Mat3::Zero();  ///< of (x, y, theta) from the points alone, in the map's frame
};

/// Fits a scan near a guess: Gauss-Newton on each point's distance from the line through the nearest point of
/// the map, with a Cauchy weight, and on the guess.
/// @param guess_information  of the guess (x, y, theta); zero: it is only where the search begins
SurfaceFit fit_surface(std::span<const SurfacePoint> surface, const SurfaceMap& map, const Pose2& guess,
                       const Mat3& guess_information);

/// How far fit_surface_far searches to every side of its guess.
struct SearchReach {
  double position_m = 0.6;
  double heading_rad = 45 * kDegree;
};

/// The same far from a good guess: tries a grid of poses first and fits from the best of them.
SurfaceFit fit_surface_far(std::span<const SurfacePoint> surface, const SurfaceMap& map, const Pose2& guess,
                           const SearchReach& reach);

}  // namespace aisle
