#include "simulated_record.hpp"

#include <utility>

#include "aisle/formats/map_messages.hpp"

namespace aisle {

Result<Observation> SimulatedRecord::keep(Observation observation) {
  pictures_ += observation.pictures.size();
  if (!session_) return observation;
  const SimulatedTruth& truth = vehicle_.truth();
  auto kept = session_->keep(std::move(observation));
  if (!kept) return kept.problems();
  Problems problems = session_->keep_truth(truth.stamp_s, truth.T_world_vehicle);
  if (!problems.empty()) return problems;
  return kept;
}

Problems SimulatedRecord::keep(const Decision& decision) {
  return session_ ? session_->keep(decision) : Problems{};
}

void SimulatedRecord::show_pose(const UncertainPose2& T_map_vehicle) const {
  if (!session_ || session_->watcher() == nullptr) return;
  const ros::Stamp_ns stamp = ros::stamp_ns(vehicle_.truth().stamp_s);
  session_->watcher()->take(pose_topic(), stamp, pose_cdr(stamp, T_map_vehicle));
}

void SimulatedRecord::show_plan(const Path& path) const {
  if (!session_ || session_->watcher() == nullptr) return;
  const ros::Stamp_ns stamp = ros::stamp_ns(vehicle_.truth().stamp_s);
  session_->watcher()->take(plan_topic(), stamp, plan_cdr(stamp, path));
}

Result<std::optional<SessionRecord>> open_session(const std::filesystem::path& out, bool force,
                                                  const VehicleDescription& vehicle,
                                                  const SessionOrigin& origin, MessageSink* watcher) {
  if (out.empty() && watcher == nullptr) return std::optional<SessionRecord>{};
  auto record = out.empty() ? SessionRecord::shown(*watcher, vehicle, origin)
                            : SessionRecord::create(out, force, vehicle, origin);
  if (!record) return record.problems();
  if (watcher != nullptr) record->show_to(*watcher);
  return std::optional<SessionRecord>(std::move(*record));
}

Problems close(std::optional<SessionRecord>& session) {
  return session ? session->close() : Problems{};
}

}  // namespace aisle
