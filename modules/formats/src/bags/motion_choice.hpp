#pragma once

#include "bags/bag_streams.hpp"

namespace aisle {

/// The odometry of a recording: of the chosen topic; of /tf if there is none, or if it misses what /tf has;
/// of a topic of poses; or none, with a warning. Always odom -> vehicle, never map -> odom.
BagMotion choose_motion(BagStreams& streams, const TopicChoice& choice, const RecordingOptions& options,
                        const std::string& file, Problems& warnings);

}  // namespace aisle
