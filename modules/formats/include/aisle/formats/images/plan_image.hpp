#pragma once
/// Floor plans as images in which dark pixels are walls; see docs/formats/plan.md.

#include <filesystem>
#include <string>
#include <string_view>

#include "aisle/core/image.hpp"
#include "aisle/core/result.hpp"
#include "aisle/simulation/plans/floor_plan.hpp"

namespace aisle {

/// Which grey values are free, by map_server's rule; thresholds are fractions of black (0 white, 1 black).
struct PlanThresholds {
  double free_below = 0.196;  ///< the rest is solid: walls and unknown pixels
  bool negate = false;        ///< white is occupied
};

/// The plan that a grey image shows, row 0 at the top. The lower left corner is the origin of `world`.
FloorPlan floor_plan(const Image& grey, double cell_m, const PlanThresholds& thresholds = {});

/// Reads PBM, PGM or any format of read_image(), recognised by the first bytes. At most 8192 columns or rows.
/// @param cell_m  side of a pixel
Result<FloorPlan> read_plan_image(const std::filesystem::path& path, double cell_m);

/// The same from memory; `name` is the file name in problems.
Result<FloorPlan> parse_plan_image(std::string_view bytes, const std::string& name, double cell_m,
                                   const PlanThresholds& thresholds = {});

}  // namespace aisle
