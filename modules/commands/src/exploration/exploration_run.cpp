#include "exploration/exploration_run.hpp"

#include <algorithm>
#include <utility>

namespace aisle {

std::optional<Observation> ExplorationRun::sense() {
  if (former_) {
    if (auto observation = sense_again()) return observation;
    if (!problems_.empty()) return std::nullopt;
    former_.reset();
  }
  auto observation = vehicle_.sense();
  if (!observation) return observation;
  observation->stamp_s += former_s_;
  if (observation->scan) observation->scan->stamp_s += former_s_;
  for (CameraImage& image : observation->images) image.stamp_s += former_s_;
  return observation;
}

std::optional<Observation> ExplorationRun::sense_again() {
  if (sensed_ == former_->T_world_vehicle.size()) return std::nullopt;
  auto cycle = former_->cycles.next();
  if (!cycle) {
    problems_ = cycle.problems();
    return std::nullopt;
  }
  if (!*cycle) return std::nullopt;
  const std::vector<Pose2>& T_world = former_->T_world_vehicle;
  if (sensed_ > 0) former_path_m_ += (T_world[sensed_].position() - T_world[sensed_ - 1].position()).norm();
  ++sensed_;
  former_s_ = (*cycle)->observation.stamp_s;
  return std::move((*cycle)->observation);
}

void ExplorationRun::act(const Command& command) {
  if (!former_) vehicle_.act(command);
}

const Pose2& ExplorationRun::T_world_vehicle() const {
  if (!former_) return vehicle_.truth().T_world_vehicle;
  return former_->T_world_vehicle[std::max<std::size_t>(sensed_, 1) - 1];
}

}  // namespace aisle
