#pragma once
/// What shows a slice of the surroundings at one height: a range scanner, or laser markers seen by a camera.

#include <memory>
#include <string>
#include <vector>

#include "aisle/vehicle/observation.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// A fan of ranges as LaserScanner describes it.
struct SliceView {
  std::vector<float> ranges_m;  ///< 0: nothing usable; the scanner's reach or more: nothing seen
  std::vector<float> near_m;    ///< what is nearer was not looked at; empty: everything was
};

class SliceSensor {
 public:
  virtual ~SliceSensor() = default;
  /// How the fan lies on the vehicle.
  virtual const LaserScanner& fan() const = 0;
  /// @return whether the observation shows a slice
  virtual bool look(const Observation& observation, SliceView& view) = 0;
};

/// The vehicle's range scanner; throws std::invalid_argument if it has none.
std::unique_ptr<SliceSensor> scanner_slices(const VehicleDescription& vehicle);

/// The laser markers' stripes in the pictures of one camera; throws std::invalid_argument if the vehicle
/// lacks either.
std::unique_ptr<SliceSensor> marker_slices(const VehicleDescription& vehicle, const std::string& camera);

}  // namespace aisle
