#pragma once
/// Floor plans as images in which dark pixels are walls; see docs/formats/plan.md.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/images/image_file.hpp"
#include "aisle/simulation/plans/floor_plan.hpp"

namespace aisle {

inline constexpr double kSolidFromBlack =
    0.196;  ///< share of black: white and what is brighter than grey 205 is free

/// A plan as it was read, and what had to be guessed.
struct PlanReading {
  FloorPlan plan;
  Problems warnings;
  std::vector<std::uint8_t> unseen = {};  ///< per cell of the plan: solid only because nobody has seen it;
                                          ///< empty: every solid cell is a wall
};

/// The plan that a grey image shows, row 0 at the top. Transparent pixels are solid: nobody has seen them.
/// The lower left corner is the origin of `world`.
/// @param solid_from_black  the share of black from which a pixel is solid: 0 white, 1 black
FloorPlan floor_plan(const TransparentImage& grey, double cell_m, double solid_from_black = kSolidFromBlack);

/// Reads PBM, PGM or any format of read_image(), recognised by the first bytes. At most 8192 columns or rows
/// and 33 million pixels.
/// @param cell_m  side of a pixel
Result<PlanReading> read_plan_image(const std::filesystem::path& path, double cell_m,
                                    double solid_from_black = kSolidFromBlack);

/// The same from memory; `name` is the file name in problems. Warns of transparent pixels, and of light grey
/// ones that count as free: walls are drawn so.
Result<PlanReading> parse_plan_image(std::string_view bytes, const std::string& name, double cell_m,
                                     double solid_from_black = kSolidFromBlack);

/// The pixels alone, coloured ones as they are.
Result<TransparentImage> parse_plan_pixels(std::string_view bytes, const std::string& name);

}  // namespace aisle
