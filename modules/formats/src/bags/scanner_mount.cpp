#include "bags/scanner_mount.hpp"

#include <fmt/format.h>

#include <cmath>

namespace aisle {
namespace {

constexpr double kLevelMount = 0.98;  ///< cosine of about 11 degrees

}  // namespace

std::string base_frame(const BagMotion& motion, const TransformTree& transforms) {
  if (transforms.has_frame(motion.child)) return motion.child;
  for (const char* name : {"base_link", "base_footprint", "base"}) {
    if (const auto frame = transforms.frame_ending(name)) return *frame;
  }
  return motion.child.empty() ? "base_link" : motion.child;
}

bool mount_scanner(const TransformTree& transforms, const std::string& base, std::vector<BagScan>& scans,
                   LaserScanner& laser, Problem warning, Problems& warnings) {
  const std::string& frame = scans.front().frame;
  const auto warn = [&](std::string what) {
    warning.what = std::move(what);
    warnings.push_back(warning);
  };
  if (frame == base) {
    warn(fmt::format(
        "its scans are in the vehicle's own frame '{}', so the bag does not tell where the scanner sits",
        base));
    return false;
  }
  const auto T_base_laser = transforms.find(base, frame);
  if (!T_base_laser) {
    warn(fmt::format(
        "no fixed transforms lead from '{}' to '{}', so the bag does not tell where the scanner sits", base,
        frame));
    return false;
  }
  laser.T_vehicle_laser = in_the_plane(*T_base_laser);
  const double up = T_base_laser->linear()(2, 2);
  if (up < 0) {
    for (BagScan& scan : scans) turn_over(scan);
    warn("the scanner hangs upside down; its scans are turned over");
  }
  if (std::abs(up) < kLevelMount) warn("the scanner is tilted; its scans are taken as if it were level");
  return true;
}

}  // namespace aisle
