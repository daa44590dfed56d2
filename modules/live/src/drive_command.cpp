#include "aisle/live/drive_command.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "aisle/formats/json_document.hpp"

namespace aisle {
namespace {

constexpr double kNumberMax = 1e6;

/// The number at `key`, 0 if there is none; nullopt if the value is not a number.
std::optional<double> number_at(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) return 0;
  if (!found->is_number()) return std::nullopt;
  const auto number = found->get<double>();
  return std::isfinite(number) && std::abs(number) <= kNumberMax ? std::optional(number) : std::nullopt;
}

}  // namespace

std::optional<DriveCommand> parse_drive_command(std::string_view json) {
  const auto document = parse_json(json, "");
  if (!document || !document->is_object()) return std::nullopt;
  const nlohmann::json& object = *document;
  const auto lease = object.find("lease"), sequence = object.find("sequence");
  if (lease == object.end() || !lease->is_string()) return std::nullopt;
  if (sequence == object.end() || !sequence->is_number_unsigned()) return std::nullopt;
  const auto age = number_at(object, "age_s"), speed = number_at(object, "speed_mps"),
             steering = number_at(object, "steering_rad"), turn = number_at(object, "turn_rate_rad_s");
  if (!age || *age < 0 || !speed || !steering || !turn) return std::nullopt;
  return DriveCommand{.lease = lease->get<std::string>(),
                      .sequence = sequence->get<std::uint64_t>(),
                      .age_s = *age,
                      .command = {.speed_mps = *speed, .steering_rad = *steering, .turn_rate_rad_s = *turn}};
}

void DriveInbox::begin_lease() {
  const std::lock_guard lock(mutex_);
  newest_.reset();
  last_sequence_.reset();
}

bool DriveInbox::put(const DriveCommand& command) {
  const std::lock_guard lock(mutex_);
  if (last_sequence_ && command.sequence <= *last_sequence_) return false;
  last_sequence_ = command.sequence;
  newest_ = command;
  put_s_ = clock_.now_s();
  return true;
}

std::optional<DriveCommand> DriveInbox::take() {
  const std::lock_guard lock(mutex_);
  auto taken = std::exchange(newest_, std::nullopt);
  if (taken) taken->age_s += clock_.now_s() - put_s_;
  return taken;
}

}  // namespace aisle
