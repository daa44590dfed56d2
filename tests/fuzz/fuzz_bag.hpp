#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "aisle/formats/bags/bag_overview.hpp"
#include "aisle/formats/bags/laser_bag.hpp"
#include "fuzz_input.hpp"

namespace aisle {

/// Reads the fuzzer's input as a bag whose name ends so, from a memory file system if there is one.
inline void read_as_bag(const std::string& ending, const std::uint8_t* bytes, std::size_t size) {
  const std::filesystem::path memory = "/dev/shm";
  std::error_code error;
  const auto base =
      std::filesystem::is_directory(memory, error) ? memory : std::filesystem::temp_directory_path();
  const auto path = base / ("aisle-fuzz-bag-" + std::to_string(::getpid()) + ending);
  std::ofstream(path, std::ios::binary) << fuzz_text(bytes, size);
  const auto overview = bag_overview(path);
  require(!overview.ok() || overview->messages >= 0);
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
