#pragma once
/// What shows a scan of the surroundings at one height: a range scanner, or laser markers seen by a camera.

#include <memory>
#include <string>
#include <vector>

#include "aisle/vehicle/observation.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// A fan of ranges as LaserScanner describes it.
struct ScanView {
  std::vector<float> ranges_m;  ///< 0: nothing usable; the scanner's reach or more: nothing seen
  std::vector<float> near_m;    ///< what is nearer was not looked at; empty: everything was
};

class ScanSource {
 public:
  virtual ~ScanSource() = default;
  /// How the fan lies on the vehicle.
  virtual const LaserScanner& fan() const = 0;
  /// @return whether the observation shows a scan
  virtual bool look(const Observation& observation, ScanView& view) = 0;
};

/// The vehicle's range scanner; throws std::invalid_argument if it has none.
std::unique_ptr<ScanSource> scanner_scans(const VehicleDescription& vehicle);

/// The laser markers' stripes in the images of one camera; throws std::invalid_argument if the vehicle
/// lacks either.
std::unique_ptr<ScanSource> marker_scans(const VehicleDescription& vehicle, const std::string& camera);

}  // namespace aisle
