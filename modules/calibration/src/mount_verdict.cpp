#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aisle/calibration/mount_calibration.hpp"
#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

using enum CalibrationQuality;

/// One deviation against what is good and what is still usable.
void judge_deviation(const char* what, double value, double good, double usable, const char* unit,
                     CalibrationVerdict& verdict) {
  if (value <= good) return;
  verdict.limit(value <= usable ? kUsable : kPoor,
                fmt::format("the {} is known to {:.2g} {} only: more points, farther apart, at the sides too",
                            what, value, unit));
}

}  // namespace

CalibrationVerdict judge(const MountCalibration& c) {
  CalibrationVerdict verdict;
  judge_deviation("height", 1000 * c.deviations.p_vehicle_camera.z(), 3, 15, "mm", verdict);
  judge_deviation("tilt", to_degrees(c.deviations.tilt_rad), 0.1, 0.5, "deg", verdict);
  judge_deviation("pan", to_degrees(c.deviations.pan_rad), 0.2, 1, "deg", verdict);
  if (c.is_ambiguous) {
    verdict.limit(kPoor,
                  "a second, different mount explains the points as well: use points nearer to the "
                  "camera and over more of the image");
  }
  const auto left_out = std::count(c.fits.begin(), c.fits.end(), false);
  if (left_out > 0) {
    const bool are_many = 4 * static_cast<std::size_t>(left_out) > c.fits.size();
    verdict.limit(are_many ? kPoor : kUsable,
                  fmt::format("{} of {} points do not fit: are their places and pixels right?", left_out,
                              c.fits.size()));
  }
  if (c.rms_px > 1) {
    verdict.limit(
        c.rms_px > 3 ? kPoor : kUsable,
        fmt::format("the residual of {:.2f} px is high: check the points' places and the lens", c.rms_px));
  }
  return verdict;
}

}  // namespace aisle
