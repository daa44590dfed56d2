#include "aisle/connection/robot_diagnostics.hpp"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/formats/sessions/diagnostic_messages.hpp"

namespace aisle {
namespace {

constexpr const char* kTopic = "/diagnostics";
constexpr double kPublishEvery_s = 1;

std::vector<ros::KeyValue> values_of(const ConnectionCounts& counts) {
  const auto text = [](const auto& value) { return fmt::format("{}", value); };
  const auto seconds = [](double value) { return fmt::format("{:.2f}", value); };
  std::vector<ros::KeyValue> values = {{"odometry age (s)", seconds(counts.odometry_age_s)},
                                       {"messages", text(counts.messages)},
                                       {"unreadable", text(counts.unreadable)},
                                       {"scans skipped", text(counts.scans_skipped)},
                                       {"images skipped", text(counts.images_skipped)},
                                       {"odometry late", text(counts.odometry_late)},
                                       {"odometry leaps", text(counts.odometry_leaps)},
                                       {"commands aged", text(counts.commands_aged)},
                                       {"holds", text(counts.holds)},
                                       {"held (s)", seconds(counts.held_s)}};
  if (counts.scan_age_s) values.push_back({"scan age (s)", seconds(*counts.scan_age_s)});
  if (counts.image_age_s) values.push_back({"image age (s)", seconds(*counts.image_age_s)});
  return values;
}

}  // namespace

RobotDiagnostics::RobotDiagnostics(Wire& wire, const Clock& clock, Progress& next)
    : clock_(clock), next_(next), published_s_(-std::numeric_limits<double>::infinity()) {
  auto publisher = wire.advertise(kTopic, ros::DiagnosticArray::kType, WireQuality::kDefault);
  if (publisher) publisher_ = std::move(*publisher);  // nothing that is driven depends on it
}

void RobotDiagnostics::note(const std::string& what) {
  noted_ = what;
  publish();
}

void RobotDiagnostics::report(std::string_view task, std::size_t done, std::size_t total) {
  next_.report(task, done, total);
  const bool is_new = state_ != task;
  state_ = task;
  if (is_new || clock_.now_s() - published_s_ >= kPublishEvery_s) publish();
}

void RobotDiagnostics::publish() {
  if (!publisher_) return;
  published_s_ = clock_.now_s();
  const bool is_held = noted_.starts_with("held");
  ros::DiagnosticStatus status;
  status.level = is_held ? ros::DiagnosticStatus::kWarning : ros::DiagnosticStatus::kOk;
  status.name = "aisle: vehicle";
  status.message = is_held ? noted_ : state_;
  ros::DiagnosticArray message;
  if (vehicle_ != nullptr) {
    if (const std::string ended = vehicle_->end_reason(); !ended.empty()) {
      status.level = ros::DiagnosticStatus::kError;
      status.message = "ended: " + ended;
    }
    status.values = values_of(vehicle_->counts());
    message.header.stamp = ros::time_of(vehicle_->odometry().stamp);
  }
  message.status.push_back(std::move(status));
  publisher_->publish(cdr_bytes(message));
}

}  // namespace aisle
