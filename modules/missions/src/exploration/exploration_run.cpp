#include "aisle/missions/exploration/exploration_run.hpp"

#include <utility>

namespace aisle {

std::optional<Observation> ExplorationRun::sense() {
  if (former_) {
    if (auto observation = sense_again()) return observation;
    if (!problems_.empty()) return std::nullopt;
    former_.reset();
  }
  return sense_on();
}

std::optional<Observation> ExplorationRun::sense_again() {
  const std::vector<Pose2>& T_world = former_->T_world_vehicle;
  if (known_truth_ != nullptr && sensed_ == T_world.size()) return std::nullopt;
  auto cycle = former_->cycles.next();
  if (!cycle) {
    problems_ = cycle.problems();
    return std::nullopt;
  }
  if (!*cycle) return std::nullopt;
  former_s_ = (*cycle)->observation.stamp_s;
  if (known_truth_ != nullptr) {
    if (sensed_ > 0) former_path_m_ += (T_world[sensed_].position() - T_world[sensed_ - 1].position()).norm();
    truth_ = {.stamp_s = former_s_, .T_world_vehicle = T_world[sensed_], .path_m = former_path_m_};
  }
  ++sensed_;
  return std::move((*cycle)->observation);
}

std::optional<Observation> ExplorationRun::sense_on() {
  auto observation = vehicle_.sense();
  if (known_truth_ != nullptr) {
    truth_ = known_truth_->truth();
    truth_.stamp_s += former_s_;
    truth_.path_m += former_path_m_;
  }
  if (!observation) return observation;
  observation->stamp_s += former_s_;
  if (observation->scan) observation->scan->stamp_s += former_s_;
  for (CameraImage& image : observation->images) image.stamp_s += former_s_;
  return observation;
}

void ExplorationRun::act(const Command& command) {
  if (!former_) vehicle_.act(command);
}

}  // namespace aisle
