#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <string>

#include "pose.hpp"

namespace robots {

/// What the motors are asked for. Steering is that of each front wheel; vehicles without leave it at zero.
struct MotorTargets {
  double left_wheel_radps = 0;
  double right_wheel_radps = 0;
  double left_steering_rad = 0;
  double right_steering_rad = 0;
};

/// A joint's angle and how fast it turns.
struct JointReading {
  double angle_rad = 0;
  double rate_radps = 0;
};

/// MuJoCo with the model of model_of().
class Physics {
 public:
  /// Throws std::runtime_error with MuJoCo's words.
  explicit Physics(const std::string& model);

  void drive(const MotorTargets& targets);
  void advance(double duration_s);

  double time_s() const { return data_->time; }
  Pose2 T_world_vehicle() const;
  JointReading joint(const char* name) const;
  /// Whether the hull touches anything.
  bool hull_touches() const;

  const mjModel* model() const { return model_.get(); }
  mjData* data() const { return data_.get(); }
  /// @return the number of what MuJoCo knows by this name, as mjOBJ_SITE "laser"
  int id(mjtObj kind, const char* name) const;

 private:
  std::unique_ptr<mjModel, void (*)(mjModel*)> model_;
  std::unique_ptr<mjData, void (*)(mjData*)> data_;
  int body_, hull_;
};

}  // namespace robots
