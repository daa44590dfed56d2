#pragma once

#include <optional>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// The laser's mounting according to the two poses of each scan, as long as all scans agree. (They disagree
/// where the laser's pose was corrected afterwards, or the two were not read at the same time.)
class RecordedMounting {
 public:
  void add(const Pose2& T_odom_vehicle, const Pose2& T_odom_laser);

  std::optional<Pose2> agreed() const { return all_agree_ ? first_ : std::nullopt; }

 private:
  std::optional<Pose2> first_;
  bool all_agree_ = true;
};

/// Whether a mounting says more than that the scanner is at the vehicle's origin, as formats do by default.
bool is_off_origin(const Pose2& T_vehicle_laser);

}  // namespace aisle
