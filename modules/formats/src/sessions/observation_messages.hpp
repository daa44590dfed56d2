#pragma once
/// An observation as messages, exactly: what comes back is what went in, but for what a lossy image coding
/// takes away and stamps being whole nanoseconds.

#include <span>
#include <string>
#include <vector>

#include "aisle/formats/images/image_coding.hpp"
#include "aisle/vehicle/observation.hpp"
#include "aisle/vehicle/vehicle_description.hpp"
#include "sessions/session_topics.hpp"

namespace aisle {

std::vector<RecordedMessage> messages_of(const Observation& observation, const VehicleDescription& vehicle,
                                         const ImageCoding& coding);

/// Messages of one stamp, in their order; those of other topics are not looked at.
/// @return nullopt where no odometry reading is among them: they are no cycle
Result<std::optional<Observation>> observation_of(ros::Stamp_ns stamp,
                                                  std::span<const RecordedMessage> messages,
                                                  const std::string& file);

}  // namespace aisle
