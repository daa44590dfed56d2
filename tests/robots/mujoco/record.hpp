#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "pose.hpp"

namespace robots {

nlohmann::json to_json(const Pose2& pose);

/// What truly happened, for those who judge.
class Record {
 public:
  /// One cycle of the robot.
  struct Cycle {
    double time_s = 0;  ///< at its end
    double duration_s = 0;
    Pose2 T_world_vehicle;  ///< at its end
    double commanded_speed_mps = 0;
    bool command_is_fresh = false;
    bool hull_touches = false;
  };

  explicit Record(const Pose2& T_world_start)
      : T_world_start_(T_world_start), T_world_end_(T_world_start), trace_{T_world_start} {}

  void note_command(double time_s);
  void note(const Cycle& cycle);

  nlohmann::json report() const;

 private:
  Pose2 T_world_start_, T_world_end_;
  double true_path_m_ = 0, commanded_path_m_ = 0;
  long commands_ = 0, cycles_ = 0, cycles_without_command_ = 0, contacts_ = 0;
  std::vector<Pose2> trace_;  ///< every few centimetres
  std::optional<double> last_command_s_, last_motion_s_, first_contact_s_, last_touch_s_;
};

}  // namespace robots
