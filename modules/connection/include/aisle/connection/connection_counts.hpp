#pragma once

#include <cstddef>
#include <optional>

namespace aisle {

/// What was counted while a robot was driven.
struct ConnectionCounts {
  std::size_t messages = 0;        ///< that arrived, of all topics
  std::size_t unreadable = 0;      ///< of them
  std::size_t scans_skipped = 0;   ///< because newer ones came before they were looked at
  std::size_t images_skipped = 0;  ///< the same of images
  std::size_t scans_foreign = 0;   ///< scans or images of another frame: a second sensor on the topic
  std::size_t out_of_order = 0;    ///< stamps that were not newer than the one before
  std::size_t clock_gaps = 0;      ///< stamps more than a second ahead of the one before
  std::size_t odometry_late = 0;   ///< cycles for which the odometry was carried on
  std::size_t odometry_leaps = 0;  ///< that were left out
  std::size_t commands_aged = 0;   ///< replaced by: stop
  std::size_t holds = 0;           ///< how often the vehicle was held
  double held_s = 0;               ///< how long
  // Since the latest one arrived; none: there is no such sensor.
  std::optional<double> scan_age_s;
  std::optional<double> image_age_s;  ///< of the camera that is longest silent
  double odometry_age_s = 0;
};

}  // namespace aisle
