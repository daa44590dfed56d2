#pragma once
/// Maps of CMU's course on localisation, as text; see docs/formats/bee.md.

#include <cstddef>
#include <string>
#include <string_view>

#include "aisle/core/result.hpp"
#include "aisle/formats/images/plan_image.hpp"

namespace aisle {

/// The plan that a Bee map shows. Its frame `world` is the map's: the corner of cell (0, 0) is the origin.
/// Every problem has its line.
Result<PlanReading> parse_bee_map(std::string_view text, const std::string& name);

/// How many of a file's first bytes tell such a map.
inline constexpr std::size_t kBeeMapHead = 64;

/// Whether a text with these first bytes is such a map.
bool begins_bee_map(std::string_view head);

}  // namespace aisle
