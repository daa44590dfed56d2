#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "aisle/control/path.hpp"

namespace aisle {

/// Where the vehicle came from: what it drove over is free, so it can go back there as it came, where no
/// other path is found. What it has gone back is forgotten.
class Trail {
 public:
  /// Once a cycle, on the way on.
  /// @param scan  the latest of the log
  void go_on(const Pose2& T_map_vehicle, std::size_t scan);
  /// Once a cycle, on the way back.
  void go_back(const Pose2& T_map_vehicle);
  /// A place was recognised.
  /// @param T_map_vehicle  one a scan
  void lay_again(std::span<const Pose2> T_map_vehicle);

  /// Back along the trail from where the vehicle stands, which is at its end; forwards where it came
  /// backwards.
  /// @param path_m  at least so far, and on ...
  /// @param is_roomy  ... to a place where the vehicle can do something else again; or else to the trail's
  /// start
  /// @return empty: no trail is left
  Path path_back(const Pose2& T_map_vehicle, double path_m,
                 const std::function<bool(const Pose2& T_map_vehicle)>& is_roomy) const;

 private:
  struct Mark {
    Pose2 T_map_vehicle;
    std::size_t scan = 0;
  };

  std::vector<Mark> marks_;
  Mark latest_;        ///< where the vehicle was a cycle ago
  int direction_ = 0;  ///< forwards 1, backwards -1: how it drove last
};

}  // namespace aisle
