#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>

#include "aisle/commands/map.hpp"
#include "aisle/core/problem.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle::python {

/// A recording of laser scans, shared by whatever looks into it.
struct Recording {
  std::shared_ptr<const LaserLog> log;
  Problems warnings;
};

/// What a user says of a recording, as keywords: `units`, `laser_offset`, `scan_topic`, `odometry`.
RecordingOptions reading_of(const std::string& units, const pybind11::object& laser_offset,
                            const std::string& scan_topic, const std::string& odometry);

}  // namespace aisle::python
