#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "aisle/learning/walls/map_building.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// Knows where the vehicle is while it drives through a building for the first time: every scan is laid onto
/// the walls that the scans before it showed, and where a place is recognised the path since then is
/// corrected.
class OnlineMapping {
 public:
  OnlineMapping(const MapParams& params, const LaserScanner& laser);
  ~OnlineMapping();

  /// The next scan.
  /// @param ranges_m  one a beam of the scanner
  /// @param T_last_now  of the vehicle, since the scan before, by odometry
  /// @return whether a place was recognised: the poses of earlier scans are others now, and so is this
  /// one's
  bool take_scan(std::span<const float> ranges_m, const Pose2& T_last_now);

  /// At the latest scan, as known now. At the first scan the vehicle is about the origin of `map`, heading
  /// along an axis as nearly as the walls show one.
  const Pose2& T_map_vehicle() const { return T_map_vehicle_; }
  /// Where the vehicle stood at an earlier scan by the walls that were seen last, near a guess; nothing where
  /// that scan does not fit them.
  std::optional<Pose2> lay_again(std::size_t scan, const Pose2& T_map_guess);
  /// At all scans, as known now.
  std::vector<Pose2> T_map_vehicle_of_all() const;

 private:
  class Work;
  std::unique_ptr<Work> work_;
  Pose2 T_map_vehicle_;
};

}  // namespace aisle
