#include "aisle/commands/sessions/session_info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aisle/commands/packed_recording.hpp"
#include "aisle/formats/sessions/imported_session.hpp"
#include "aisle/formats/sessions/session_cycles.hpp"
#include "aisle/formats/sessions/session_summary.hpp"
#include "sessions/recording_info.hpp"

namespace aisle {
namespace {

constexpr std::size_t kGapsShown = 20;  // per topic

double to_thousandths(double value) {
  return std::round(value * 1000) / 1000;
}

double rate_hz(const TopicSummary& topic) {
  return topic.interval_s > 0 ? 1 / topic.interval_s : 0;
}

nlohmann::ordered_json gaps_json(const std::vector<SessionGap>& gaps) {
  auto json = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < std::min(gaps.size(), kGapsShown); ++i)
    json.push_back({{"start_s", gaps[i].start_s}, {"length_s", gaps[i].length_s}});
  return json;
}

nlohmann::ordered_json topic_json(const TopicSummary& topic) {
  return {{"name", topic.topic.name},
          {"type", topic.topic.type},
          {"messages", topic.messages},
          {"bytes", topic.bytes},
          {"rate_hz", to_thousandths(rate_hz(topic))},
          {"regular", topic.is_regular},
          {"gap_count", topic.gaps.size()},
          {"gaps", gaps_json(topic.gaps)}};
}

/// What recorded the session.
nlohmann::ordered_json origin_json(const SessionCycles& cycles) {
  const SessionOrigin& origin = cycles.origin();
  nlohmann::ordered_json json = {{"navigator", origin.navigator},
                                 {"parameters", origin.parameters},
                                 {"seed", origin.seed},
                                 {"simulated", origin.simulated},
                                 {"vehicle", cycles.vehicle().name}};
  if (!origin.route.empty()) {
    json["route"] = origin.route;
    json["in_reverse"] = origin.in_reverse;
  }
  if (!origin.has_odometry) json["odometry"] = false;
  if (!origin.has_calibration) json["calibration"] = false;
  return json;
}

std::string imported_text(const SessionOrigin& origin, const VehicleDescription& vehicle) {
  return fmt::format("imported, {} odometry; {}\n", origin.has_odometry ? "with" : "without",
                     origin.has_calibration ? fmt::format("vehicle '{}'", vehicle.name)
                                            : "how its sensors sit is not known");
}

std::string origin_text(const SessionCycles& cycles) {
  const SessionOrigin& origin = cycles.origin();
  if (origin.navigator == kImportedNavigator) return imported_text(origin, cycles.vehicle());
  const std::string route = origin.route.empty() ? ""
                                                 : fmt::format(" along route '{}'{}", origin.route,
                                                               origin.in_reverse ? " in reverse" : "");
  return fmt::format("{}vehicle '{}' driven by navigator '{}'{}, seed {}\n",
                     origin.simulated ? "simulated " : "", cycles.vehicle().name, origin.navigator, route,
                     origin.seed);
}

std::string topic_line(const TopicSummary& topic, std::size_t name_width) {
  const std::string rate = topic.is_regular ? fmt::format("{:8.2f} Hz", rate_hz(topic)) : "";
  return fmt::format("  {:<{}}  {:>8}  {:>11}  {:>9.3f} MB  {}\n", topic.topic.name, name_width,
                     topic.messages, rate, static_cast<double>(topic.bytes) * 1e-6, topic.topic.type);
}

std::string gap_lines(const TopicSummary& topic) {
  std::string text;
  for (std::size_t i = 0; i < std::min(topic.gaps.size(), kGapsShown); ++i) {
    text += fmt::format("gap: no {} for {:.3f} s from {:.3f} s on\n", topic.topic.name,
                        topic.gaps[i].length_s, topic.gaps[i].start_s);
  }
  if (topic.gaps.size() > kGapsShown)
    text += fmt::format("gap: {} has {} more\n", topic.topic.name, topic.gaps.size() - kGapsShown);
  return text;
}

/// Whether a path names a folder of SQLite files with metadata: if it cannot be read, that is what is wrong.
bool may_be_session(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_directory(path, error)) return false;
  for (std::filesystem::directory_iterator entry(path, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->path().extension() == ".mcap" || entry->path().extension() == ".bag") return false;
  }
  return true;
}

std::string summary_text(const SessionSummary& summary) {
  std::size_t name_width = 0;
  for (const TopicSummary& topic : summary.topics) name_width = std::max(name_width, topic.topic.name.size());
  std::string text =
      fmt::format("{:.3f} s, {} messages on {} topics, {:.3f} MB\n", summary.duration_s(), summary.messages,
                  summary.topics.size(), static_cast<double>(summary.file_bytes) * 1e-6);
  for (const TopicSummary& topic : summary.topics) text += topic_line(topic, name_width);
  for (const TopicSummary& topic : summary.topics) text += gap_lines(topic);
  return text;
}

Result<Outcome> info_of(const SessionInfoOptions& options, Console& console) {
  const auto summary = summarise_session(options.input);
  if (!summary && may_be_session(options.input)) return summary.problems();
  const auto cycles = SessionCycles::open(options.input);
  if (!cycles && summary && summary->topics.empty()) return cycles.problems();  // killed at once
  if (!cycles) return recording_info(options.input, console);
  if (!summary) return summary.problems();

  Outcome outcome{.verb = "info"};
  outcome.figures = {{"duration_s", summary->duration_s()},
                     {"messages", summary->messages},
                     {"file_bytes", summary->file_bytes},
                     {"origin", origin_json(*cycles)},
                     {"topics", nlohmann::ordered_json::array()}};
  for (const TopicSummary& topic : summary->topics) outcome.figures["topics"].push_back(topic_json(topic));
  outcome.text = summary_text(*summary) + origin_text(*cycles);
  return outcome;
}

}  // namespace

Result<Outcome> run_session_info(const SessionInfoOptions& options, Console& console) {
  return with_unpacked(options, &SessionInfoOptions::input, console, info_of);
}

}  // namespace aisle
