#pragma once

#include <string>
#include <vector>

#include "aisle/formats/logs/laser_recording.hpp"
#include "bags/bag_streams.hpp"

namespace aisle {

/// All that a bag's chosen topics tell but for the images themselves, on one clock.
struct BagRecording {
  LaserRecording lasers;  ///< odometry, and scans if they are chosen
  BagImages images;
  std::vector<double> image_times_s;  ///< of each, never decreasing
  TransformTree transforms;
  std::string base;  ///< the vehicle's frame
};

Result<BagRecording> read_bag_recording(BagReader& bag, const TopicChoice& choice,
                                        const RecordingOptions& options, const std::string& file);

}  // namespace aisle
