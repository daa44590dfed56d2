#pragma once
/// Sources of 2-D scans at one height: a range scanner, or line lasers seen by a camera.

#include <memory>
#include <string>
#include <vector>

#include "aisle/vehicle/observation.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// A polar scan; LaserScanner describes its beams.
struct ScanView {
  std::vector<float> ranges_m;  ///< one per beam. 0: no usable reading; the maximum range or more: no hit
  std::vector<float> near_m;    ///< one per beam: the blind zone before it; empty: there is none
};

class ScanSource {
 public:
  virtual ~ScanSource() = default;
  /// Beam angles, range and mounting pose of the scan.
  virtual const LaserScanner& scanner() const = 0;
  /// @param view  set if the observation has a scan, else unchanged
  /// @return whether it has
  virtual bool look(const Observation& observation, ScanView& view) = 0;
};

/// The vehicle's range scanner; throws std::invalid_argument if it has none.
std::unique_ptr<ScanSource> scanner_scans(const VehicleDescription& vehicle);

/// Scans by the laser markers' stripe in the images of one camera; throws std::invalid_argument if the
/// vehicle lacks either.
std::unique_ptr<ScanSource> marker_scans(const VehicleDescription& vehicle, const std::string& camera);

}  // namespace aisle
