#include "aisle/formats/sessions/session_cycles.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "aisle/formats/sessions/decision_text.hpp"
#include "aisle/formats/sessions/session_reader.hpp"
#include "aisle/formats/worlds/vehicle_yaml.hpp"
#include "sessions/image_messages.hpp"
#include "sessions/observation_messages.hpp"

namespace aisle {
namespace {

/// Whether a replay reads the topic.
bool is_of_cycle(const std::string& topic) {
  return topic == kWheelsTopic || topic == kScanTopic || topic == kBumperTopic || topic == kOperatorTopic ||
         topic == kDecisionTopic || camera_of(topic).has_value();
}

/// The text of a topic with which every session begins.
Result<std::string> head_text(const SessionReader& reader, const char* topic) {
  const std::string file = reader.database().string();
  const auto bytes = reader.first_of(topic);
  if (!bytes) return bytes.problems();
  if (!bytes->has_value() && reader.topics().empty())
    return Problem{{file}, "holds no message: the session ended before its first second was written"};
  if (!bytes->has_value())
    return Problem{{file, 0, topic},
                   "is missing: this bag is not an aisle session; `aisle import` makes one of it"};
  auto text = decoded<ros::String>({{topic, ros::String::kType, true}, **bytes}, file);
  if (!text) return text.problems();
  return std::move(text->data);
}

Result<std::optional<Decision>> decision_of(const std::vector<RecordedMessage>& messages,
                                            const std::string& file) {
  std::optional<Decision> decision;
  for (const RecordedMessage& message : messages) {
    if (message.topic.name != kDecisionTopic) continue;
    const auto text = decoded<ros::String>(message, file);
    if (!text) return text.problems();
    decision = parse_decision(text->data);
    if (!decision) return Problem{{file, 0, kDecisionTopic}, "has a message that is not a decision"};
  }
  return decision;
}

/// The problems, each with the time of its cycle.
Problems at_time(Problems problems, ros::Stamp_ns stamp) {
  for (Problem& problem : problems) problem.what += fmt::format(" (at {:.3f} s)", ros::stamp_s(stamp));
  return problems;
}

}  // namespace

class SessionCycles::Source {
 public:
  Source(SessionReader messages, VehicleDescription vehicle, SessionOrigin origin)
      : messages_(std::move(messages)), vehicle_(std::move(vehicle)), origin_(std::move(origin)) {}

  const VehicleDescription& vehicle() const { return vehicle_; }
  const SessionOrigin& origin() const { return origin_; }
  Result<std::optional<SessionCycle>> next();

 private:
  Problems read_ahead();
  Problems take_stamp(ros::Stamp_ns stamp);
  Result<std::optional<SessionCycle>> cycle_at(ros::Stamp_ns stamp) const;

  SessionReader messages_;
  VehicleDescription vehicle_;
  SessionOrigin origin_;
  std::optional<std::pair<ros::Stamp_ns, RecordedMessage>> ahead_;
  std::vector<RecordedMessage> of_stamp_;
  bool has_begun_ = false;
};

/// Advances to the next relevant message.
Problems SessionCycles::Source::read_ahead() {
  ahead_.reset();
  while (true) {
    const auto message = messages_.next();
    if (!message) return message.problems();
    if (!message->has_value()) return {};
    const SessionReader::Message& found = **message;
    if (!is_of_cycle(found.topic.name)) continue;
    ahead_ = {found.stamp, RecordedMessage{found.topic, std::string(found.cdr)}};
    return {};
  }
}

Problems SessionCycles::Source::take_stamp(ros::Stamp_ns stamp) {
  of_stamp_.clear();
  while (ahead_ && ahead_->first == stamp) {
    of_stamp_.push_back(std::move(ahead_->second));
    if (Problems problems = read_ahead(); !problems.empty()) return problems;
  }
  return {};
}

Result<std::optional<SessionCycle>> SessionCycles::Source::cycle_at(ros::Stamp_ns stamp) const {
  const std::string file = messages_.database().string();
  auto observation = observation_of(stamp, of_stamp_, file, origin_.has_odometry);
  if (!observation) return at_time(observation.problems(), stamp);
  auto decision = decision_of(of_stamp_, file);
  if (!decision) return at_time(decision.problems(), stamp);
  if (!observation->has_value()) return std::optional<SessionCycle>();
  return std::optional(SessionCycle{std::move(**observation), std::move(*decision)});
}

Result<std::optional<SessionCycle>> SessionCycles::Source::next() {
  if (!std::exchange(has_begun_, true)) {
    if (Problems problems = read_ahead(); !problems.empty()) return problems;
  }
  while (ahead_) {
    const ros::Stamp_ns stamp = ahead_->first;
    if (Problems problems = take_stamp(stamp); !problems.empty()) return problems;
    auto cycle = cycle_at(stamp);
    if (!cycle || cycle->has_value()) return cycle;
  }
  return std::optional<SessionCycle>();
}

SessionCycles::SessionCycles(std::unique_ptr<Source> source) : source_(std::move(source)) {}
SessionCycles::SessionCycles(SessionCycles&&) noexcept = default;
SessionCycles& SessionCycles::operator=(SessionCycles&&) noexcept = default;
SessionCycles::~SessionCycles() = default;

Result<SessionCycles> SessionCycles::open(const std::filesystem::path& directory) {
  auto reader = SessionReader::open(directory);
  if (!reader) return reader.problems();
  const std::string file = reader->database().string();
  const auto origin_text = head_text(*reader, kOriginTopic);
  if (!origin_text) return origin_text.problems();
  auto origin = parse_session_origin(*origin_text, file + ": " + kOriginTopic);
  if (!origin) return origin.problems();
  const auto vehicle_text = head_text(*reader, kVehicleTopic);
  if (!vehicle_text) return vehicle_text.problems();
  auto vehicle = parse_vehicle(*vehicle_text, file + ": " + kVehicleTopic);
  if (!vehicle) return vehicle.problems();
  return SessionCycles(
      std::make_unique<Source>(std::move(*reader), std::move(vehicle->description), std::move(*origin)));
}

const VehicleDescription& SessionCycles::vehicle() const {
  return source_->vehicle();
}

const SessionOrigin& SessionCycles::origin() const {
  return source_->origin();
}

Result<std::optional<SessionCycle>> SessionCycles::next() {
  return source_->next();
}

}  // namespace aisle
