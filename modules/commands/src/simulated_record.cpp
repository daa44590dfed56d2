#include "simulated_record.hpp"

#include <utility>

#include "aisle/formats/sessions/map_messages.hpp"

namespace aisle {

Result<Observation> SimulatedRecord::keep(Observation observation) {
  images_ += observation.images.size();
  image_camera_.clear();
  if (!observation.images.empty()) {
    image_camera_ = observation.images.front().camera;
    image_stamp_s_ = observation.images.front().stamp_s;
  }
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

void SimulatedRecord::show(const SessionTopic& topic, const std::string& cdr) const {
  session_->watcher()->take(topic, ros::stamp_ns(vehicle_.truth().stamp_s), cdr);
}

void SimulatedRecord::show_pose(const UncertainPose2& T_map_vehicle) const {
  if (is_watched()) show(pose_topic(), pose_cdr(ros::stamp_ns(vehicle_.truth().stamp_s), T_map_vehicle));
}

void SimulatedRecord::show_plan(const Path& path) const {
  if (is_watched()) show(plan_topic(), plan_cdr(ros::stamp_ns(vehicle_.truth().stamp_s), path));
}

void SimulatedRecord::show_match(const ViewMatch& match) const {
  if (is_watched()) show(match_topic(), match_cdr(vehicle_.truth().stamp_s, match));
}

void SimulatedRecord::show_overlay(const Overlay& overlay) const {
  if (is_watched() && !image_camera_.empty())
    show(overlay_topic(image_camera_), overlay_cdr(image_stamp_s_, overlay));
}

void SimulatedRecord::show_floor(const FloorGrid& floor) {
  constexpr double kFloorEvery_s = 2;
  const double stamp_s = vehicle_.truth().stamp_s;
  if (!is_watched() || (floor_shown_s_ >= 0 && stamp_s - floor_shown_s_ < kFloorEvery_s)) return;
  floor_shown_s_ = stamp_s;
  std::string cdr = floor_cdr(floor);
  if (cdr == floor_shown_) return;
  show(floor_topic(), cdr);
  floor_shown_ = std::move(cdr);
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
