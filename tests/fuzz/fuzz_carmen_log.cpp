#include <cmath>

#include "aisle/formats/logs/carmen_log.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

namespace {

void check(const LaserLog& log) {
  require(!log.scans.empty() && log.laser().T_vehicle_laser.is_finite());
  double time_s = log.scans.front().time_s;
  for (const LaserScan& scan : log.scans) {
    require(scan.ranges_m.size() == log.scans.front().ranges_m.size());
    require(scan.odometry_known <= log.odometry.size());
    require(scan.time_s >= time_s);
    time_s = scan.time_s;
    for (const float range_m : scan.ranges_m) require(range_m >= 0 && std::isfinite(range_m));
  }
  for (const OdometrySample& sample : log.odometry) require(sample.T_odom_vehicle.is_finite());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  for (const LengthUnit unit : {LengthUnit::kMetre, LengthUnit::kCentimetre}) {
    CarmenOptions options;
    options.unit = unit;
    const auto carmen = parse_carmen_log(fuzz_text(bytes, size), "input", options);
    if (carmen.ok()) check(carmen->log);
  }
  return 0;
}
