#pragma once

#include <optional>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// Compares the path that the wheels count with the path that the map shows, over the last metres. Wheels
/// that slip for a moment, or are some percent off, are left to the localiser. Wheels that count half as far
/// again mislead all that goes by odometry: obstacles that are out of view, stopping paths, bridging.
class OdometryMonitor {
 public:
  /// The vehicle's pose by odometry and on the map, where an image matched the map.
  void look(const Pose2& T_odom_vehicle, const Pose2& T_map_vehicle);

  /// The same, where it has relocalised. Farther off than wheels explain, it was kidnapped: the comparison
  /// begins anew.
  void relocalise(const Pose2& T_odom_vehicle, const Pose2& T_map_vehicle);

  /// How many times the path that the map shows the wheels count, if that is too far from 1.
  std::optional<double> off_by() const;

 private:
  struct Poses {
    Pose2 T_odom_vehicle, T_map_vehicle;
  };

  std::optional<Poses> last_;
  double counted_m_ = 0, shown_m_ = 0;  ///< forward, older path counting less
};

}  // namespace aisle
