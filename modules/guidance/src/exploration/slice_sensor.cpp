#include "aisle/guidance/exploration/slice_sensor.hpp"

#include <stdexcept>

namespace aisle {
namespace {

class ScannerSlices final : public SliceSensor {
 public:
  explicit ScannerSlices(const LaserScanner& scanner) : scanner_(scanner) {}

  const LaserScanner& fan() const override { return scanner_; }
  bool look(const Observation& observation, SliceView& view) override {
    if (!observation.scan) return false;
    view.ranges_m = observation.scan->ranges_m;
    view.near_m.clear();
    return true;
  }

 private:
  LaserScanner scanner_;
};

}  // namespace

std::unique_ptr<SliceSensor> scanner_slices(const VehicleDescription& vehicle) {
  if (!vehicle.scanner) throw std::invalid_argument("the vehicle has no range scanner");
  return std::make_unique<ScannerSlices>(*vehicle.scanner);
}

}  // namespace aisle
