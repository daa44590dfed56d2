#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// The beam directions of a FLASER line with `beams` readings (2 or more): the usual ones of scanners with so
/// many.
/// @param resolution_deg  PARAM laser_front_laser_resolution; it wins if that many beams fit into a circle
ScanBeams flaser_beams(std::size_t beams, std::optional<double> resolution_deg);

/// Those of a scan with another number of readings than most of its log.
/// @param usual  of the scans with `usual_count` readings
ScanBeams flaser_beams_like(const ScanBeams& usual, std::size_t usual_count, std::size_t beams,
                            std::optional<double> resolution_deg);

/// The other directions that scanners with `beams` readings have; none where the number tells the scanner.
std::vector<ScanBeams> other_flaser_beams(std::size_t beams);

}  // namespace aisle
