#include "bags/bag_log.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "aisle/core/median.hpp"
#include "bags/bag_clock.hpp"

namespace aisle {
namespace {

constexpr double kRangeMaxUnknown_m = 30;

template <class Messages>
MessageStream stream_of(const std::string& topic, const Messages& messages) {
  MessageStream stream{topic, {}};
  for (const auto& message : messages) stream.times.push_back(message.time);
  return stream;
}

/// Whether the messages of all topics follow each other topic by topic, as some converters write them: the
/// order in the file says nothing then, only when each was recorded.
bool is_by_topic(std::span<const MessageStream> streams) {
  std::vector<std::pair<long, long>> parts;  // first and last message of a topic
  for (const MessageStream& stream : streams) {
    if (!stream.times.empty()) parts.emplace_back(stream.times.front().number, stream.times.back().number);
  }
  std::sort(parts.begin(), parts.end());
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (parts[i].first < parts[i - 1].second) return false;
  }
  return parts.size() > 1;
}

double median_interval_s(const std::vector<double>& times_s) {
  std::vector<double> intervals_s;
  for (std::size_t i = 1; i < times_s.size(); ++i) intervals_s.push_back(times_s[i] - times_s[i - 1]);
  return intervals_s.empty() ? 0 : median(std::move(intervals_s));
}

/// The scanner as its first scan describes it.
void describe(LaserScanner& laser, const std::vector<BagScan>& scans) {
  laser.first_angle_rad = scans.front().beams.first_angle_rad;
  laser.angle_step_rad = scans.front().beams.angle_step_rad;
  for (const BagScan& scan : scans) laser.range_max_m = std::max(laser.range_max_m, scan.range_max_m);
  if (laser.range_max_m == 0) laser.range_max_m = kRangeMaxUnknown_m;
}

/// The time from one reading to the next, where it is plausible for a scanner that takes a scan every
/// `interval_s`.
double reading_period_s(const BagScan& scan, double interval_s) {
  const double sign = std::signbit(scan.beams.period_s) ? -1 : 1;
  const double stated_s = std::abs(scan.beams.period_s);
  if (stated_s > 0 && stated_s * static_cast<double>(scan.ranges_m.size()) < 1.5 * interval_s)
    return sign * stated_s;
  const bool is_sensible = scan.scan_time_s > 0.5 * interval_s && scan.scan_time_s < 1.5 * interval_s;
  // The head turns once per scan, and the readings may cover less than the circle.
  return is_sensible ? sign * scan.scan_time_s * scan.beams.angle_step_rad / (360 * kDegree) : 0;
}

/// @param first_s  the time of the reading that was measured first
LaserScan log_scan(BagScan& from, const LaserScanner& laser, double first_s) {
  LaserScan scan;
  scan.stamp_s = ros::stamp_s(from.time.stamp);
  scan.time_s = first_s + std::abs(from.beams.period_s) * static_cast<double>(from.ranges_m.size() - 1) / 2;
  scan.line = from.time.number;
  scan.ranges_m = std::move(from.ranges_m);
  const auto range_max_m = static_cast<float>(laser.range_max_m);
  for (float& range_m : scan.ranges_m) range_m = std::min(range_m, range_max_m);
  const bool is_usual = from.beams.period_s == 0 && from.beams.first_angle_rad == laser.first_angle_rad &&
                        from.beams.angle_step_rad == laser.angle_step_rad;
  if (!is_usual) scan.beams = from.beams;
  return scan;
}

}  // namespace

std::vector<double> fill_log(LaserLog& log, std::vector<std::vector<BagScan>>& scans,
                             const std::vector<std::string>& topics, const BagMotion& motion,
                             const std::string& image_topic, const std::vector<MessageTime>& images,
                             const std::string& file, Problems& warnings) {
  std::vector<MessageStream> streams;
  for (std::size_t i = 0; i < scans.size(); ++i) streams.push_back(stream_of(topics[i], scans[i]));
  if (!images.empty()) streams.push_back({image_topic, images});
  streams.push_back(stream_of(motion.source, motion.poses));
  const std::vector<std::vector<double>> times_s = stream_times_s(streams, file, warnings);
  const bool by_topic = is_by_topic(streams);
  const auto place_of = [&](const MessageTime& time) {
    return by_topic ? time.log_stamp : ros::Stamp_ns{time.number};
  };

  std::vector<ros::Stamp_ns> odometry_places;
  for (std::size_t i = 0; i < motion.poses.size(); ++i) {
    const BagPose& pose = motion.poses[i];
    log.odometry.push_back({times_s.back()[i], pose.T_parent_child, pose.time.number});
    odometry_places.push_back(place_of(pose.time));
  }
  std::vector<std::pair<ros::Stamp_ns, LaserScan>> placed;
  for (std::size_t laser = 0; laser < scans.size(); ++laser) {
    describe(log.lasers[laser], scans[laser]);
    const double interval_s = median_interval_s(times_s[laser]);
    for (std::size_t i = 0; i < scans[laser].size(); ++i) {
      BagScan& from = scans[laser][i];
      from.beams.period_s = reading_period_s(from, interval_s);
      placed.emplace_back(place_of(from.time), log_scan(from, log.lasers[laser], times_s[laser][i]));
      placed.back().second.laser = laser;
    }
  }
  std::stable_sort(placed.begin(), placed.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  double time_s = -std::numeric_limits<double>::infinity();
  for (auto& [place, scan] : placed) {
    time_s = scan.time_s = std::max(scan.time_s, time_s);
    const auto known = std::lower_bound(odometry_places.begin(), odometry_places.end(), place);
    scan.odometry_known = static_cast<std::size_t>(known - odometry_places.begin());
    log.scans.push_back(std::move(scan));
  }
  return images.empty() ? std::vector<double>() : times_s[scans.size()];
}

}  // namespace aisle
