#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "aisle/control/path.hpp"
#include "aisle/vehicle/gear.hpp"

namespace aisle {

/// The path that the vehicle came along. The floor that it drove over is free, so it can go back as it came
/// where no other path is found. What it has gone back over is forgotten.
class Trail {
 public:
  /// Once a cycle, while driving on.
  /// @param scan  index of the last scan in the log
  void go_on(const Pose2& T_map_vehicle, std::size_t scan);
  /// Once a cycle, while driving back along the trail.
  void go_back(const Pose2& T_map_vehicle);
  /// Moves the trail with its scans after a loop closure.
  /// @param T_map_vehicle  one pose per scan
  void lay_again(std::span<const Pose2> T_map_vehicle);

  /// The path back along the trail from its end, where the vehicle stands; forwards where it came backwards.
  /// @param path_m    minimum length ...
  /// @param is_roomy  ... after which it ends where there is enough clearance, or at the trail's start
  /// @return empty if no trail is left
  Path path_back(const Pose2& T_map_vehicle, double path_m,
                 const std::function<bool(const Pose2& T_map_vehicle)>& is_roomy) const;

  /// The trail's first part, driven back to where it began.
  /// @param T_map_begin  where the trail began, by what is known now
  /// @param away_m       nearer than this to its beginning the path begins where the vehicle is, if that is
  ///                     on the trail; else farther away ...
  /// @param is_roomy     ... where there is enough clearance
  /// @return empty if the trail has no such pose
  Path path_to_begin(const Pose2& T_map_begin, const Pose2& T_map_vehicle, double away_m,
                     const std::function<bool(const Pose2& T_map_vehicle)>& is_roomy) const;

 private:
  struct Mark {
    Pose2 T_map_vehicle;
    std::size_t scan = 0;
  };

  std::vector<Mark> marks_;
  Mark latest_;               ///< where the vehicle was a cycle ago
  std::optional<Gear> gear_;  ///< in which it drove last
};

}  // namespace aisle
