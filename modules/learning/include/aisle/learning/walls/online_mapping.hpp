#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "aisle/learning/walls/map_building.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// SLAM on a first drive through a building: every scan is fitted to the walls that earlier scans showed;
/// when a place is recognised, the path since then is corrected.
class OnlineMapping {
 public:
  OnlineMapping(const MapParams& params, const LaserScanner& laser);
  ~OnlineMapping();

  /// Takes the next scan.
  /// @param ranges_m  one per beam of the scanner
  /// @param T_last_now  the vehicle's motion since the previous scan, by odometry
  /// @return whether a place was recognised: then the poses of earlier scans and of this one have changed
  bool take_scan(std::span<const float> ranges_m, const Pose2& T_last_now);

  /// At the latest scan, as known now. At the first scan the vehicle is near the origin of `map`, and an axis
  /// of `map` is parallel to the walls if they show a direction.
  const Pose2& T_map_vehicle() const { return T_map_vehicle_; }
  /// Fits an earlier scan to the most recently seen walls, near a guess, and returns the vehicle's pose;
  /// nullopt if the scan does not fit them.
  std::optional<Pose2> lay_again(std::size_t scan, const Pose2& T_map_guess);
  /// At all scans, as known now.
  std::vector<Pose2> T_map_vehicle_of_all() const;

 private:
  class Work;
  std::unique_ptr<Work> work_;
  Pose2 T_map_vehicle_;
};

}  // namespace aisle
