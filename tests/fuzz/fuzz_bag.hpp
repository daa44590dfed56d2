#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "aisle/formats/bags/bag_overview.hpp"
#include "aisle/formats/bags/laser_bag.hpp"
#include "aisle/formats/image_sequences/image_sequence.hpp"
#include "fuzz_file.hpp"

namespace aisle {

/// Reads the images of a topic to their end.
inline void read_images(const std::filesystem::path& bag, const std::string& topic) {
  const auto images = open_image_sequence(bag.string(), {.rate_hz = {}, .front_steered = {}, .topic = topic});
  if (!images) return;
  double stamp_s = -1;
  while (true) {
    const auto image = (*images)->next();
    if (!image || !image->has_value()) return;
    require((*image)->stamp_s > stamp_s && !(*image)->bytes.empty());
    require((*image)->T_odom_vehicle.has_value() == (*images)->has_odometry());
    stamp_s = (*image)->stamp_s;
  }
}

/// Reads the fuzzer's input as a bag whose name ends so.
inline void read_as_bag(const std::string& ending, const std::uint8_t* bytes, std::size_t size) {
  const auto path = fuzz_file(ending, bytes, size);
  const auto overview = bag_overview(path);
  require(!overview.ok() || overview->messages >= 0);
  for (const auto& topic : overview ? overview->topics : std::vector<BagOverview::Topic>()) {
    if (topic.serves == "camera") read_images(path, topic.topic.name);
  }
  const auto recording = read_laser_bag(path);
  if (!recording) return;
  double time_s = 0;
  for (const LaserScan& scan : recording->log.scans) {
    require(scan.laser < recording->log.lasers.size());
    require(scan.odometry_known <= recording->log.odometry.size());
    require(&scan == recording->log.scans.data() || scan.time_s >= time_s);
    time_s = scan.time_s;
  }
}

}  // namespace aisle
