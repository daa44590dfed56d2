#pragma once

#include "bags/bag_streams.hpp"

namespace aisle {

/// The odometry of a recording: of the chosen topic; of /tf if there is none, or if it misses what /tf has;
/// of a topic of poses; or none. Always odom -> vehicle, never map -> odom.
/// @param wanted  as in RecordingOptions
BagMotion choose_motion(BagStreams& streams, const TopicChoice& choice, const std::string& wanted,
                        const std::string& file, Problems& warnings);

}  // namespace aisle
