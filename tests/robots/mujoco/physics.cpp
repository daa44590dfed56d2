#include "physics.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "model.hpp"

namespace robots {
namespace {

/// By itself MuJoCo writes warnings to a file beside the program, and waits for a key after an error.
void say_on_stderr() {
  mju_user_warning = [](const char* words) { std::fprintf(stderr, "mujoco_robot: MuJoCo: %s\n", words); };
  mju_user_error = [](const char* words) {
    std::fprintf(stderr, "mujoco_robot: MuJoCo: %s\n", words);
    std::_Exit(1);
  };
}

/// MuJoCo reads files alone, but also from a file system in memory.
mjModel* loaded(const std::string& model) {
  say_on_stderr();
  constexpr const char* kName = "model.xml";
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), kName, static_cast<int>(model.size()));
  std::memcpy(files->filedata[0], model.data(), model.size());
  char problem[500] = "";
  mjModel* result = mj_loadXML(kName, files.get(), problem, sizeof problem);
  mj_deleteVFS(files.get());
  if (result == nullptr) throw std::runtime_error(std::string("MuJoCo: ") + problem);
  return result;
}

}  // namespace

Physics::Physics(const std::string& model)
    : model_(loaded(model), mj_deleteModel), data_(mj_makeData(model_.get()), mj_deleteData) {
  body_ = id(mjOBJ_BODY, "base_link");
  hull_ = id(mjOBJ_GEOM, "hull");
  mj_forward(model_.get(), data_.get());
}

void Physics::drive(const MotorTargets& targets) {
  const double values[] = {targets.left_wheel_radps, targets.right_wheel_radps, targets.left_steering_rad,
                           targets.right_steering_rad};
  for (int i = 0; i < model_->nu; ++i) data_->ctrl[i] = values[i];
}

void Physics::advance(double duration_s) {
  for (long steps = std::lround(duration_s / kStep_s); steps > 0; --steps) mj_step(model_.get(), data_.get());
}

Pose2 Physics::T_world_vehicle() const {
  const mjtNum* p = data_->xpos + 3 * body_;
  const mjtNum* R = data_->xmat + 9 * body_;
  return {p[0], p[1], std::atan2(R[3], R[0])};
}

JointReading Physics::joint(const char* name) const {
  const int number = id(mjOBJ_JOINT, name);
  return {data_->qpos[model_->jnt_qposadr[number]], data_->qvel[model_->jnt_dofadr[number]]};
}

bool Physics::hull_touches() const {
  for (int i = 0; i < data_->ncon; ++i) {
    if (data_->contact[i].geom1 == hull_ || data_->contact[i].geom2 == hull_) return true;
  }
  return false;
}

int Physics::id(mjtObj kind, const char* name) const {
  const int number = mj_name2id(model_.get(), kind, name);
  if (number < 0) throw std::runtime_error(std::string("the model has no ") + name);
  return number;
}

}  // namespace robots
