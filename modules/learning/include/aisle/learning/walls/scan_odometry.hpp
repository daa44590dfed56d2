#pragma once

#include <optional>
#include <span>
#include <vector>

#include "aisle/matching/point_alignment.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

inline constexpr double kScanMatchingReach_m = 20;  ///< farther readings move too much with the heading

/// How a scanner moved since its previous scan; (x, y, theta) are in the frame of that scan.
struct ScanMotion {
  UncertainPose2 T_last_now;        ///< of the laser, by all that is known
  double share = 1;                 ///< of the scan's points that lie on what was seen before
  Mat3 information = Mat3::Zero();  ///< by the points alone, as if their errors were independent
};

/// Odometry from scan to scan, with or without wheels: each scan is fitted to the scans before it, and the
/// motion is the mean of what the points, the wheels and the last speed say, each by its information. Works
/// in any surroundings with edges; along a bare corridor the points know nothing and the wheels decide, or,
/// without wheels, the last speed goes on. Wheels that the scans contradict (frozen, catching up, slipping,
/// late) are taken to be as wrong as they were lately.
class ScanOdometry {
 public:
  /// Takes the next scan.
  /// @param points   of surfaces, in the laser's frame, in the order of the beams
  /// @param time_s   of the scan; not before the last one's
  /// @param counted  the laser's motion since the last scan by the wheels
  ScanMotion step(std::span<const Vec2> points, double time_s,
                  const std::optional<UncertainPose2>& counted = {});

  /// The laser's pose in the frame of the first scan.
  const Pose2& T_first_laser() const { return T_map_laser_; }

 private:
  UncertainPose2 coasted(double step_s) const;
  SurfaceFit fit(const Pose2& T_last_expected, const Pose2& T_last_coasted, double step_s) const;
  void doubt(const Vec3& off, const Vec3& expected_variance);
  void learn();

  SurfaceMap map_;
  std::vector<SurfacePoint> surface_;
  Pose2 T_map_laser_;
  Pose2 T_map_learned_;  ///< where the map was extended last
  std::optional<double> last_s_;
  Vec3 velocity_ = Vec3::Zero();        ///< of the laser in its own frame [m/s, m/s, rad/s]
  Vec3 wheel_variance_ = Vec3::Zero();  ///< of the wheels beyond their noise, as they were lately
  int strange_ = 0;                     ///< scans in a row that do not fit the map
};

/// The points that a scan saw up to kScanMatchingReach_m, in the laser's frame, in the order of the beams.
/// @param swept  motion of the laser from the first beam to the last; the points are as from its middle
void points_of(const LaserScanner& laser, std::span<const float> ranges_m, std::vector<Vec2>& points,
               const Pose2& swept = {});

}  // namespace aisle
