#include "option_kinds.hpp"

#include <charconv>
#include <cmath>

#include "aisle/core/angle.hpp"

using aisle::ExploringSensor;
using aisle::kDegree;
using aisle::LengthUnit;
using aisle::MissionStart;
using aisle::Pose2;
using aisle::SessionStorage;
using aisle::wrap_angle;

namespace {

/// "x", "x,y" or "x,y,deg": pose of the laser on the vehicle [m, degrees].
Pose2 parse_offset(const std::string& text) {
  double values[3] = {0, 0, 0};
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  for (int i = 0; i < 3; ++i) {
    const auto [next, error] = std::from_chars(at, end, values[i]);
    if (error != std::errc() || !std::isfinite(values[i])) break;
    if (next == end) return {values[0], values[1], values[2] * kDegree};
    if (*next != ',') break;
    at = next + 1;
  }
  throw CLI::ValidationError("--laser-offset",
                             fmt::format("'{}' is not x, x,y or x,y,degrees (metres)", text));
}

}  // namespace

void add_reading_options(CLI::App& verb, aisle::RecordingOptions& reading) {
  verb.add_option("--scan", reading.scan_topic, "topic of the scans in a bag (default: chosen, and said)");
  verb.add_option(
      "--odometry", reading.odometry,
      "topic of the odometry in a bag, or tf; none: by the scans alone (default: chosen, and said)");
  add_choice<LengthUnit>(
      verb, "--units", reading.unit,
      {{"m", LengthUnit::kMetre}, {"cm", LengthUnit::kCentimetre}, {"mm", LengthUnit::kMillimetre}},
      "unit of lengths in a laser log (default m)");
  verb.add_option_function<std::string>(
      "--laser-offset", [&reading](const std::string& text) { reading.T_vehicle_laser = parse_offset(text); },
      "pose of the laser on the vehicle: x, x,y or x,y,degrees (default: from the recording, else 0)");
}

void add_storage(CLI::App& verb, SessionStorage& storage) {
  add_choice<SessionStorage>(verb, "--storage", storage,
                             {{"sqlite", SessionStorage::kSqlite}, {"mcap", SessionStorage::kMcap}},
                             "file of the new session (default sqlite)");
}

void add_seed(CLI::App& verb, std::uint64_t& seed, const std::string& meaning) {
  const auto read = [&seed](const std::string& text) {
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, seed);
    if (error == std::errc() && rest == end) return;
    throw CLI::ValidationError("--seed",
                               fmt::format("'{}' is not a whole number from 0 to {}", text, UINT64_MAX));
  };
  verb.add_option_function<std::string>("--seed", read, meaning)->type_name("NUMBER");
}

void add_exploring_sensor(CLI::App& verb, ExploringSensor& sensor, const std::string& meaning) {
  add_choice<ExploringSensor>(
      verb, "--sensor", sensor,
      {{"scanner", ExploringSensor::kScanner}, {"markers", ExploringSensor::kMarkers}}, meaning);
}

void add_resolution(CLI::App& verb, double& pixel_m) {
  verb.add_option("--resolution", pixel_m,
                  "metres per pixel of a plan whose file does not give it (default 0.05)")
      ->check(CLI::Range(0.001, 10.0));
}

Pose2 parse_place(const std::string& option, const std::string& text) {
  constexpr double kFarthest_m = 1e6;
  double values[3] = {0, 0, 0};
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  for (int i = 0; i < 3; ++i) {
    const auto [next, error] = std::from_chars(at, end, values[i]);
    if (error != std::errc() || !(std::abs(values[i]) < kFarthest_m)) break;
    if (i == 2 && next == end) return {values[0], values[1], wrap_angle(values[2] * kDegree)};
    if (next == end || *next != ',') break;
    at = next + 1;
  }
  throw CLI::ValidationError(option, fmt::format("'{}' is not x,y,degrees (metres)", text));
}

MissionStart parse_told_start(const std::string& text) {
  if (text == "home") return {};
  if (text == "unknown") return {.is_unknown = true, .T_map_hint = {}};
  return {.is_unknown = false, .T_map_hint = parse_place("--at", text)};
}
