#include "aisle/formats/bags/laser_bag.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bags/bag_log.hpp"
#include "bags/bag_recording.hpp"
#include "bags/motion_choice.hpp"
#include "bags/scanner_mount.hpp"

namespace aisle {
namespace {

double share_seen(const BagScan& scan) {
  const auto seen = std::count_if(scan.ranges_m.begin(), scan.ranges_m.end(),
                                  [](float range_m) { return range_m > 0 && std::isfinite(range_m); });
  return static_cast<double>(seen) / static_cast<double>(scan.ranges_m.size());
}

/// Two publishers on one topic are told apart by their frames; the one that sees most is kept.
void keep_one_publisher(std::vector<BagScan>& scans, const std::string& topic, const std::string& file,
                        Problems& warnings) {
  std::map<std::string, std::pair<long, double>> frames;  // scans, and how much they see
  for (const BagScan& scan : scans) {
    auto& [count, seen] = frames[scan.frame];
    ++count;
    seen += share_seen(scan);
  }
  if (frames.size() < 2) return;
  const auto best = std::max_element(frames.begin(), frames.end(), [](const auto& a, const auto& b) {
    return a.second.second < b.second.second;
  });
  std::string list;
  for (const auto& [frame, counts] : frames)
    list +=
        fmt::format("{}'{}' ({} scans, {:.0f} % of their readings are distances)", list.empty() ? "" : ", ",
                    frame, counts.first, 100 * counts.second / static_cast<double>(counts.first));
  warnings.push_back({{file, 0, topic},
                      fmt::format("comes from {} publishers, by their frames {}; '{}' is taken",
                                  frames.size(), list, best->first)});
  std::erase_if(scans, [&](const BagScan& scan) { return scan.frame != best->first; });
}

void tell_doubts(const ScanDoubts& doubts, const std::string& topic, const std::string& file,
                 Problems& warnings) {
  const auto percent = [&](long readings) {
    return 100 * static_cast<double>(readings) / static_cast<double>(std::max(1L, doubts.readings));
  };
  if (doubts.not_numbers + doubts.too_near > 0)
    warnings.push_back(
        {{file, 0, topic},
         fmt::format(
             "{:.1f} % of the readings tell nothing: {} are nan, -inf or negative, {} below range_min",
             percent(doubts.not_numbers + doubts.too_near), doubts.not_numbers, doubts.too_near)});
  if (percent(doubts.too_far) > 0.1)
    warnings.push_back({{file, 0, topic},
                        fmt::format("{:.1f} % of the readings are beyond range_max: nothing seen",
                                    percent(doubts.too_far))});
  if (doubts.angles_by_view > 0)
    warnings.push_back(
        {{file, doubts.first_by_view, topic},
         fmt::format(
             "{} scans have another number of readings than angle_increment and angle_max say; the increment "
             "is rounded, so the field of view / (readings - 1) is taken",
             doubts.angles_by_view)});
  if (doubts.angles_by_step > 0)
    warnings.push_back(
        {{file, 0, topic},
         fmt::format("{} scans have another number of readings than angle_max says; angle_min and "
                     "angle_increment are taken",
                     doubts.angles_by_step)});
}

Problems joined(Problems first, const Problems& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// Of each topic of scans, those of one publisher.
Problems settle_scans(BagStreams& streams, const std::vector<std::string>& topics, const std::string& file,
                      Problems& warnings) {
  for (std::size_t i = 0; i < topics.size(); ++i) {
    if (streams.scans[i].empty()) return {{{file, 0, topics[i]}, "has no scan that can be read"}};
    keep_one_publisher(streams.scans[i], topics[i], file, warnings);
    tell_doubts(streams.doubts[i][streams.scans[i].front().frame], topics[i], file, warnings);
  }
  return {};
}

}  // namespace

Result<BagRecording> read_bag_recording(BagReader& bag, const TopicChoice& choice,
                                        const RecordingOptions& options, const std::string& file) {
  BagRecording recording;
  Problems& warnings = recording.lasers.warnings;
  auto streams = read_streams(bag, choice, file, warnings);
  if (!streams) return streams.problems();
  std::vector<std::string> topics;
  for (const std::size_t topic : choice.scans) topics.push_back(bag.topics()[topic].name);
  if (Problems problems = settle_scans(*streams, topics, file, warnings); !problems.empty()) return problems;
  const BagMotion motion = choose_motion(*streams, choice, options.odometry, file, warnings);
  LaserLog& log = recording.lasers.log;
  log.lasers.resize(std::max<std::size_t>(1, topics.size()));
  recording.base = base_frame(motion, streams->transforms);
  for (std::size_t i = 0; i < topics.size(); ++i) {
    const bool is_mounted = mount_scanner(streams->transforms, recording.base, streams->scans[i],
                                          log.lasers[i], {{file, 0, topics[i]}, {}}, warnings);
    if (i == 0) recording.lasers.has_mounting = is_mounted;
  }
  if (options.T_vehicle_laser) {
    log.laser().T_vehicle_laser = *options.T_vehicle_laser;
    recording.lasers.has_mounting = true;
  }
  recording.images = std::move(streams->images);
  recording.transforms = std::move(streams->transforms);
  recording.image_times_s =
      fill_log(log, streams->scans, topics, motion, choice.images ? bag.topics()[*choice.images].name : "",
               recording.images.times, file, warnings);
  return recording;
}

Result<LaserRecording> read_laser_bag(const std::filesystem::path& path, const RecordingOptions& options) {
  const std::string file = path.string();
  auto bag = BagReader::open(path);
  if (!bag) return bag.problems();
  Problems choices;
  const auto choice = choose_topics(*bag, options, file, choices);
  if (!choice) return joined(choice.problems(), bag->warnings());
  auto recording = read_bag_recording(*bag, *choice, options, file);
  if (!recording) return recording.problems();
  LaserRecording& lasers = recording->lasers;
  if (lasers.log.odometry.empty() && options.odometry != "none")
    lasers.warnings.push_back({{file}, "has no odometry; the scans alone tell how the vehicle moved"});
  lasers.warnings = joined(bag->warnings(), joined(choices, lasers.warnings));
  return std::move(lasers);
}

}  // namespace aisle
