#include "record.hpp"

#include <nlohmann/json.hpp>
#include <utility>

namespace robots {
namespace {

constexpr double kStanding_mps = 0.005;
constexpr double kTraceStep_m = 0.05;
/// A hull that rebounds or scrapes makes one contact until it has been free for so long.
constexpr double kFree_s = 0.5;

nlohmann::json or_null(const std::optional<double>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json();
}

}  // namespace

nlohmann::json to_json(const Pose2& pose) {
  return {
      {"x_m", pose.x}, {"y_m", pose.y}, {"heading_deg", std::remainder(to_degrees(pose.heading_rad), 360)}};
}

void Record::note_command(double time_s) {
  ++commands_;
  last_command_s_ = time_s;
}

void Record::note(const Cycle& cycle) {
  const Pose2& T_world_vehicle = cycle.T_world_vehicle;
  const double driven_m = std::hypot(T_world_vehicle.x - T_world_end_.x, T_world_vehicle.y - T_world_end_.y);
  T_world_end_ = T_world_vehicle;
  true_path_m_ += driven_m;
  if (std::hypot(T_world_vehicle.x - trace_.back().x, T_world_vehicle.y - trace_.back().y) > kTraceStep_m)
    trace_.push_back(T_world_vehicle);
  commanded_path_m_ += std::abs(cycle.commanded_speed_mps) * cycle.duration_s;
  if (driven_m > kStanding_mps * cycle.duration_s) last_motion_s_ = cycle.time_s;
  ++cycles_;
  if (!cycle.command_is_fresh) ++cycles_without_command_;
  if (!cycle.hull_touches) return;
  if (!first_contact_s_) first_contact_s_ = cycle.time_s;
  if (!last_touch_s_ || cycle.time_s - *last_touch_s_ > kFree_s) ++contacts_;
  last_touch_s_ = cycle.time_s;
}

nlohmann::json Record::report() const {
  auto trace = nlohmann::json::array();
  for (const Pose2& pose : trace_) trace.push_back({pose.x, pose.y});
  return {{"true_start", to_json(T_world_start_)},
          {"true_end", to_json(T_world_end_)},
          {"true_path_m", true_path_m_},
          {"true_trace", std::move(trace)},
          {"commanded_path_m", commanded_path_m_},
          {"contacts", {{"count", contacts_}, {"first_s", or_null(first_contact_s_)}}},
          {"commands", commands_},
          {"last_command_s", or_null(last_command_s_)},
          {"last_motion_s", or_null(last_motion_s_)},
          {"ticks", cycles_},
          {"ticks_without_fresh_command", cycles_without_command_}};
}

}  // namespace robots
