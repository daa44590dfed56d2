#include "logs/rawlog_scans.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "aisle/core/angle.hpp"
#include "logs/carmen_beam_angles.hpp"
#include "logs/carmen_range.hpp"
#include "logs/recorded_mounting.hpp"
#include "logs/scan_beams.hpp"

namespace aisle {
namespace {

constexpr std::size_t kScannersMax = 16;
constexpr double kLevel = 0.9;  // cosine of the tilt up to which a scan is one of a plan

ScanBeams stated_beams(const MrptScan& scan) {
  const auto steps = static_cast<double>(scan.readings_m.size() - 1);
  return {-scan.aperture_rad / 2, scan.aperture_rad / steps};
}

/// MRPT's converter of CARMEN logs takes half a degree a reading for granted; scanners with so few readings
/// see the half circle.
bool understates_aperture(const MrptScan& scan) {
  const std::size_t count = scan.readings_m.size();
  const double assumed_rad = 0.5 * kDegree * static_cast<double>(count);
  return (count == 180 || count == 181) && std::abs(scan.aperture_rad - assumed_rad) < 0.6 * kDegree;
}

bool is_usable(const MrptScan& scan) {
  return scan.readings_m.size() >= 2 && scan.aperture_rad > 0 && scan.aperture_rad <= 2.1 * kPi &&
         std::isfinite(scan.range_max_m) && scan.range_max_m >= 0;
}

}  // namespace

void RawlogScans::add(const MrptScan& scan, long object) {
  if (!is_usable(scan)) return unusable_.add(object);
  if (std::abs(scan.T_vehicle_laser.up_z) < kLevel) return tilted_.add(object);
  const std::size_t laser = scanner_of(scan);
  if (laser == kScannersMax) return unusable_.add(object);

  LaserScan added;
  added.stamp_s = scan.stamp_s;
  added.odometry_known = log_.odometry.size();
  added.laser = laser;
  added.line = object;
  added.beams = stated_beams(scan);
  if (understates_aperture(scan)) {
    if (understated_.count == 0) stated_ = *added.beams;
    understated_.add(object);
    added.beams = flaser_beams(scan.readings_m.size(), std::nullopt);
  }
  add_readings(scan, object, added);
  log_.scans.push_back(std::move(added));
}

std::size_t RawlogScans::scanner_of(const MrptScan& scan) {
  const auto same = std::find_if(scanners_.begin(), scanners_.end(), [&](const Scanner& scanner) {
    const Pose2 change = between(scanner.T_vehicle_laser, scan.T_vehicle_laser.flat);
    return scanner.label == scan.label && change.position().norm() < 0.01 &&
           std::abs(change.theta) < 0.5 * kDegree;
  });
  const auto index = static_cast<std::size_t>(same - scanners_.begin());
  if (same == scanners_.end() && index < kScannersMax) {
    scanners_.push_back({scan.label, scan.T_vehicle_laser.flat, scan.range_max_m});
    LaserScanner& laser = log_.lasers.emplace_back();
    laser.T_vehicle_laser = scan.T_vehicle_laser.flat;
  }
  return index;
}

/// Seen from below, the beams of a scanner that hangs upside down run the other way.
void RawlogScans::add_readings(const MrptScan& scan, long object, LaserScan& to) {
  to.ranges_m.reserve(scan.readings_m.size());
  for (const float reading_m : scan.readings_m) to.ranges_m.push_back(readings_.kept(reading_m, object));
  std::string validity(scan.valid);
  if (scan.counter_clockwise != (scan.T_vehicle_laser.up_z > 0)) {
    std::reverse(to.ranges_m.begin(), to.ranges_m.end());
    std::reverse(validity.begin(), validity.end());
    const auto steps = static_cast<double>(to.ranges_m.size() - 1);
    to.beams->first_angle_rad = -(to.beams->first_angle_rad + steps * to.beams->angle_step_rad);
  }
  count_validity(scan);
  validity_.push_back(std::move(validity));
}

void RawlogScans::count_validity(const MrptScan& scan) {
  for (std::size_t i = 0; i < scan.valid.size(); ++i) {
    if (!(scan.readings_m[i] > 0 && scan.readings_m[i] < scan.range_max_m)) continue;
    ++in_range_;
    valid_in_range_ += scan.valid[i] != 0;
  }
}

void RawlogScans::settle_ranges() {
  for (std::size_t laser = 0; laser < scanners_.size(); ++laser) {
    std::vector<LaserScan> own;
    std::copy_if(log_.scans.begin(), log_.scans.end(), std::back_inserter(own),
                 [&](const LaserScan& scan) { return scan.laser == laser; });
    log_.lasers[laser].range_max_m =
        find_range_max_m(own, believable_maximum_m(own, scanners_[laser].announced_range_max_m));
  }
  replace_infinite_readings(log_);
}

void RawlogScans::finish(const RecordingOptions& options, const std::string& name,
                         LaserRecording& recording) {
  warn_of_contents(name, recording.warnings);
  if (understated_.count > 0) recording.other_beams.push_back(stated_);
  settle_beams(log_, name, recording.warnings);
  settle_ranges();
  if (2 * valid_in_range_ < in_range_) {
    recording.warnings.push_back(
        {{name}, "most readings in range are marked invalid: the marks are not believed"});
  } else {
    apply_validity();
  }
  if (options.T_vehicle_laser) log_.laser().T_vehicle_laser = *options.T_vehicle_laser;
  recording.has_mounting = options.T_vehicle_laser ||
                           std::any_of(log_.lasers.begin(), log_.lasers.end(), [](const LaserScanner& laser) {
                             return is_off_origin(laser.T_vehicle_laser);
                           });
}

/// Beyond the range, "invalid" means that nothing was seen; before it, that the beam tells nothing.
void RawlogScans::apply_validity() {
  for (std::size_t i = 0; i < log_.scans.size(); ++i) {
    LaserScan& scan = log_.scans[i];
    const double range_max_m = log_.lasers[scan.laser].range_max_m;
    for (std::size_t beam = 0; beam < validity_[i].size(); ++beam) {
      if (validity_[i][beam] == 0 && scan.ranges_m[beam] < range_max_m) scan.ranges_m[beam] = 0;
    }
  }
}

void RawlogScans::warn_of_contents(const std::string& name, Problems& warnings) const {
  const auto warn = [&](const Occurrences& where, std::string what) {
    if (where.count > 0) warnings.push_back({{name, where.first_line}, std::move(what)});
  };
  readings_.warn(name, warnings);
  warn(tilted_, fmt::format("object: {} scans are not level; they are left out", tilted_.count));
  warn(unusable_,
       fmt::format("object: {} scans have no readings or no angles; they are left out", unusable_.count));
  warn(understated_,
       fmt::format("object: {} scans state an aperture of {:.0f} deg, half a degree a reading; as scanners "
                   "with so many readings see 180 deg, that is taken",
                   understated_.count, -2 * to_degrees(stated_.first_angle_rad)));
}

}  // namespace aisle
