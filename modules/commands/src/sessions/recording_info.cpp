#include "sessions/recording_info.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "aisle/core/angle.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/formats/bags/bag_overview.hpp"
#include "aisle/formats/logs/read_laser_recording.hpp"

namespace aisle {
namespace {

constexpr double kSecondsPerNanosecond = 1e-9;

nlohmann::ordered_json bag_topic_json(const BagOverview::Topic& topic) {
  return {{"name", topic.topic.name},         {"type", topic.topic.type},
          {"messages", topic.topic.messages}, {"rate_hz", rounded(topic.rate_hz, 3)},
          {"serves", topic.serves},           {"frames", topic.frames}};
}

std::string bag_topic_line(const BagOverview::Topic& topic, std::size_t name_width) {
  return fmt::format("  {:<{}}  {:>8}  {:8.2f} Hz  {:<9}  {}\n", topic.topic.name, name_width,
                     topic.topic.messages, topic.rate_hz, topic.serves, topic.topic.type);
}

/// Which verbs take such a bag.
std::string what_reads(const BagOverview& overview) {
  const auto has = [&](const char* use) {
    return std::any_of(overview.topics.begin(), overview.topics.end(), [&](const BagOverview::Topic& topic) {
      return topic.serves == use && topic.topic.messages > 0;
    });
  };
  std::vector<std::string> verbs;
  if (has("scan")) verbs.emplace_back("`aisle map` maps its scans");
  if (has("camera") || has("scan")) verbs.emplace_back("`aisle import` makes a session of it");
  return verbs.empty() ? "nothing in it is of use here" : fmt::format("{}", fmt::join(verbs, ", "));
}

Result<Outcome> bag_info(const std::filesystem::path& path, Console& console) {
  const auto overview = bag_overview(path);
  if (!overview) return overview.problems();
  warn_of(overview->warnings, console);
  Outcome outcome{.verb = "info"};
  const double duration_s = kSecondsPerNanosecond * static_cast<double>(overview->last - overview->first);
  outcome.figures = {{"duration_s", rounded(duration_s, 3)},
                     {"messages", overview->messages},
                     {"origin", nullptr},
                     {"topics", nlohmann::ordered_json::array()},
                     {"warnings", warnings_json(overview->warnings)}};
  std::size_t name_width = 0;
  for (const BagOverview::Topic& topic : overview->topics)
    name_width = std::max(name_width, topic.topic.name.size());
  outcome.text = fmt::format("{:.3f} s, {} messages on {} topics\n", duration_s, overview->messages,
                             overview->topics.size());
  for (const BagOverview::Topic& topic : overview->topics) {
    outcome.figures["topics"].push_back(bag_topic_json(topic));
    outcome.text += bag_topic_line(topic, name_width);
  }
  outcome.text += "not recorded by aisle: " + what_reads(*overview) + "\n";
  return outcome;
}

Result<Outcome> log_info(const std::filesystem::path& path, Console& console) {
  const auto recording = read_laser_recording(path, {});
  if (!recording) return recording.problems();
  const LaserLog& log = recording->log;
  warn_of(recording->warnings, console);
  Outcome outcome{.verb = "info"};
  const double duration_s = log.scans.back().time_s - log.scans.front().time_s;
  const std::size_t readings = log.scans.front().ranges_m.size();
  const double field_deg = to_degrees(log.laser_of(log.scans.front()).angle_step_rad *
                                      static_cast<double>(std::max<std::size_t>(readings, 1) - 1));
  outcome.figures = {{"duration_s", rounded(duration_s, 3)},
                     {"scans", log.scans.size()},
                     {"readings", readings},
                     {"field_of_view_deg", rounded(field_deg, 2)},
                     {"range_max_m", rounded(log.laser().range_max_m, 3)},
                     {"odometry", log.odometry.size()},
                     {"warnings", warnings_json(recording->warnings)}};
  outcome.text = fmt::format("{:.1f} s, {} scans of {} readings over {:.0f} degrees, {} poses of odometry\n",
                             duration_s, log.scans.size(), readings, field_deg, log.odometry.size());
  return outcome;
}

}  // namespace

Result<Outcome> recording_info(const std::filesystem::path& recording, Console& console) {
  return is_bag(recording) ? bag_info(recording, console) : log_info(recording, console);
}

}  // namespace aisle
