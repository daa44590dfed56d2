#include "aisle/guidance/exploration/scan_source.hpp"

#include <stdexcept>

namespace aisle {
namespace {

class ScannerScans final : public ScanSource {
 public:
  explicit ScannerScans(const LaserScanner& scanner) : scanner_(scanner) {}

  const LaserScanner& scanner() const override { return scanner_; }
  bool look(const Observation& observation, ScanView& view) override {
    if (!observation.scan) return false;
    view.ranges_m = observation.scan->ranges_m;
    view.near_m.clear();
    return true;
  }

 private:
  LaserScanner scanner_;
};

}  // namespace

std::unique_ptr<ScanSource> scanner_scans(const VehicleDescription& vehicle) {
  if (!vehicle.scanner) throw std::invalid_argument("the vehicle has no range scanner");
  return std::make_unique<ScannerScans>(*vehicle.scanner);
}

}  // namespace aisle
