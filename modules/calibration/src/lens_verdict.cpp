#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "aisle/calibration/lens_calibration.hpp"
#include "aisle/core/angle.hpp"
#include "aisle/core/median.hpp"

namespace aisle {
namespace {

using enum CalibrationQuality;

/// Residuals grow with the image: the limits are those of an image 640 px wide.
double picture_scale(const LensCalibration& c) {
  return std::max(1.0, c.width_px / 640.0);
}

void judge_residuals(const LensCalibration& c, CalibrationVerdict& verdict) {
  const double scale = picture_scale(c);
  if (c.rms_px > 0.5 * scale) {
    verdict.limit(c.rms_px > 1.0 * scale ? kPoor : kUsable,
                  fmt::format("the residual of {:.2f} px is high: is the board flat, the images sharp, and "
                              "is it the right number of corners?",
                              c.rms_px));
  }
  std::vector<double> rms;
  for (const CalibratedView& view : c.views) rms.push_back(view.rms_px);
  const double usual = median(std::move(rms));
  for (const CalibratedView& view : c.views) {
    if (view.rms_px > std::max(3 * usual, 0.3 * scale)) {
      verdict.limit(kUsable, fmt::format("{} fits badly ({:.2f} px, others {:.2f} px): leave it out",
                                         view.name, view.rms_px, usual));
    }
  }
}

void judge_views(const LensCalibration& c, CalibrationVerdict& verdict) {
  if (c.views.size() < 8) {
    verdict.limit(kUsable, fmt::format("there are only {} views: 10 or more make it sure", c.views.size()));
  }
  const double turn_deg = to_degrees(c.largest_turn_rad);
  if (turn_deg < 30) {
    verdict.limit(turn_deg < 12 ? kPoor : kUsable,
                  fmt::format("the board's directions differ by {:.0f} deg only: turn it to all sides, by "
                              "about 40 deg",
                              turn_deg));
  }
}

/// Which corners of the image no board corner came near.
std::vector<std::string> bare_corners(const LensCalibration& c) {
  constexpr std::array kNames = {"upper left", "upper right", "lower left", "lower right"};
  std::array<bool, 4> is_reached{};
  for (const CalibratedView& view : c.views) {
    for (const Vec2& p : view.corners_px) {
      const double u = p.x() / c.width_px, v = p.y() / c.height_px;
      if (std::abs(u - 0.5) < 0.2 || std::abs(v - 0.5) < 0.2) continue;
      is_reached[(v > 0.5 ? 2U : 0U) + (u > 0.5 ? 1U : 0U)] = true;
    }
  }
  std::vector<std::string> bare;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (!is_reached[i]) bare.emplace_back(kNames[i]);
  }
  return bare;
}

void judge_coverage(const LensCalibration& c, CalibrationVerdict& verdict) {
  const std::vector<std::string> bare = bare_corners(c);
  if (!bare.empty()) {
    verdict.limit(kUsable, fmt::format("the board never came near the image's {} corner: the distortion is "
                                       "not known there",
                                       fmt::join(bare, ", ")));
  }
  if (c.coverage < 0.5) {
    verdict.limit(kUsable, fmt::format("the boards cover {:.0f} % of the image: hold them closer and at all "
                                       "its sides",
                                       100 * c.coverage));
  }
}

void judge_deviations(const LensCalibration& c, CalibrationVerdict& verdict) {
  const double share =
      std::max(c.deviations.fx_px / c.intrinsics.fx_px, c.deviations.fy_px / c.intrinsics.fy_px);
  if (share < 0.004) return;
  verdict.limit(
      share < 0.02 ? kUsable : kPoor,
      fmt::format("the focal length is known to {:.1f} % only: more views, closer and turned further",
                  100 * share));
}

}  // namespace

CalibrationVerdict judge(const LensCalibration& calibration) {
  CalibrationVerdict verdict;
  judge_residuals(calibration, verdict);
  judge_views(calibration, verdict);
  judge_coverage(calibration, verdict);
  judge_deviations(calibration, verdict);
  return verdict;
}

}  // namespace aisle
