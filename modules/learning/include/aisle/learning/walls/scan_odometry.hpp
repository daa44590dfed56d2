#pragma once

#include <optional>
#include <span>
#include <vector>

#include "aisle/matching/point_alignment.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

inline constexpr double kScanMatchingReach_m = 20;  ///< farther readings move too much with the heading
inline constexpr double kVehicleSpeedMax_mps = 3;   ///< of vehicles in buildings
inline constexpr double kVehicleTurnMax_radps = 4;

/// How a scanner moved since its previous scan, by the scans alone.
struct ScanMotion {
  Pose2 T_last_now;                 ///< of the laser
  double share = 1;                 ///< of the scan's points that lie on what was seen before
  Mat3 information = Mat3::Zero();  ///< of (x, y, theta) in the frame of the previous scan
};

/// Odometry without wheels: fits each scan to the scans before it. Works in any surroundings with edges;
/// along a bare corridor the distance is a guess (the last speed goes on), and `information` says so.
class ScanOdometry {
 public:
  /// Takes the next scan.
  /// @param points  of surfaces, in the laser's frame, in the order of the beams
  /// @param time_s  of the scan; not before the last one's
  ScanMotion step(std::span<const Vec2> points, double time_s);

  /// The share of a scan's points that would lie on what was seen before, near a motion since the last scan.
  double share_at(std::span<const Vec2> points, const Pose2& T_last_now);

  /// The laser's pose in the frame of the first scan.
  const Pose2& T_first_laser() const { return T_map_laser_; }

 private:
  Pose2 predicted(double time_s) const;
  void learn();

  SurfaceMap map_;
  std::vector<SurfacePoint> surface_;
  Pose2 T_map_laser_;
  Pose2 T_map_learned_;  ///< where the map was extended last
  std::optional<double> last_s_;
  Vec3 velocity_ = Vec3::Zero();  ///< of the laser in its own frame [m/s, m/s, rad/s]
};

/// The points that a scan saw up to kScanMatchingReach_m, in the laser's frame, in the order of the beams.
void points_of(const LaserScanner& laser, std::span<const float> ranges_m, std::vector<Vec2>& points);

}  // namespace aisle
