#include "aisle/missions/mission_recorder.hpp"

#include <utility>

#include "aisle/formats/sessions/map_messages.hpp"
#include "aisle/vehicle/odometry_step.hpp"

namespace aisle {

Result<Observation> MissionRecorder::keep(Observation observation) {
  stamp_s_ = observation.stamp_s;
  odometry_m_ += odometry_step(vehicle_.description(), observation.odometry).position().norm();
  images_ += observation.images.size();
  image_camera_.clear();
  if (!observation.images.empty()) {
    image_camera_ = observation.images.front().camera;
    image_stamp_s_ = observation.images.front().stamp_s;
  }
  if (!session_) return observation;
  auto kept = session_->keep(std::move(observation));
  if (!kept || T_world_vehicle() == nullptr) return kept;
  Problems problems = session_->keep_truth(stamp_s_, *T_world_vehicle());
  if (!problems.empty()) return problems;
  return kept;
}

Problems MissionRecorder::keep(const Decision& decision) {
  return session_ ? session_->keep(decision) : Problems{};
}

Problems MissionRecorder::keep_goals(std::string goals_json) {
  if (goals_json == goals_kept_) return {};
  goals_kept_ = std::move(goals_json);
  return session_->keep_goals(goals_kept_);
}

void MissionRecorder::show(const SessionTopic& topic, const std::string& cdr) const {
  session_->watcher()->take(topic, ros::stamp_ns(stamp_s_), cdr);
}

void MissionRecorder::show_pose(const UncertainPose2& T_map_vehicle) const {
  if (is_watched()) show(pose_topic(), pose_cdr(ros::stamp_ns(stamp_s_), T_map_vehicle));
}

void MissionRecorder::show_plan(const Path& path) const {
  if (is_watched()) show(plan_topic(), plan_cdr(ros::stamp_ns(stamp_s_), path));
}

void MissionRecorder::show_match(const ViewMatch& match) const {
  if (is_watched()) show(match_topic(), match_cdr(stamp_s_, match));
}

void MissionRecorder::show_overlay(const Overlay& overlay) const {
  if (is_watched() && !image_camera_.empty())
    show(overlay_topic(image_camera_), overlay_cdr(image_stamp_s_, overlay));
}

void MissionRecorder::show_floor(const FloorGrid& floor) {
  constexpr double kFloorEvery_s = 2;
  if (!is_watched() || (floor_shown_s_ >= 0 && stamp_s_ - floor_shown_s_ < kFloorEvery_s)) return;
  floor_shown_s_ = stamp_s_;
  std::string cdr = floor_cdr(floor);
  if (cdr == floor_shown_) return;
  show(floor_topic(), cdr);
  show(grid_topic(), grid_cdr(ros::stamp_ns(stamp_s_), floor));
  floor_shown_ = std::move(cdr);
}

Result<std::optional<SessionRecord>> open_session(const std::filesystem::path& out, bool force,
                                                  SessionStorage storage, const Vehicle& vehicle,
                                                  const TruthSource* truth, SessionOrigin origin,
                                                  MessageSink* watcher) {
  origin.simulated = is_simulated(truth);
  if (out.empty()) return show_session(vehicle.description(), origin, watcher);
  auto record = SessionRecord::create(out, force, vehicle.description(), origin, {}, storage);
  if (!record) return record.problems();
  if (watcher != nullptr) record->show_to(*watcher);
  return std::optional<SessionRecord>(std::move(*record));
}

Result<std::optional<SessionRecord>> show_session(const VehicleDescription& vehicle,
                                                  const SessionOrigin& origin, MessageSink* watcher) {
  if (watcher == nullptr) return std::optional<SessionRecord>{};
  auto record = SessionRecord::shown(*watcher, vehicle, origin);
  if (!record) return record.problems();
  return std::optional<SessionRecord>(std::move(*record));
}

Problems close_session(std::optional<SessionRecord>& session) {
  return session ? session->close() : Problems{};
}

}  // namespace aisle
