#pragma once
/// An observation as messages. Reading them back gives exactly the same observation, except for a lossy image
/// coding and stamps rounded to whole nanoseconds.

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

/// What the wheels counted since the cycle before.
RecordedMessage wheels_message(ros::Stamp_ns stamp, const OdometryReading& reading);

/// One turn of the scanner. @param reading_period_s  from one reading to the next; 0: not known
RecordedMessage scan_message(const RangeScan& scan, const LaserScanner& scanner, double reading_period_s = 0);

/// From the messages of one stamp, in their order; messages of other topics are ignored.
/// @param has_odometry  whether every cycle contains an odometry reading; if not, an image or a scan makes
/// one
/// @return nullopt if they are not a cycle
Result<std::optional<Observation>> observation_of(ros::Stamp_ns stamp,
                                                  std::span<const RecordedMessage> messages,
                                                  const std::string& file, bool has_odometry = true);

}  // namespace aisle
