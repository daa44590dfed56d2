#pragma once

#include <string>

#include "aisle/exploration/grid_rules.hpp"

namespace aisle {

/// The input symbols of a rule set as little pictures, after C97's Figure 3: an SVG document.
std::string input_symbols_svg(const GridRules& rules);

}  // namespace aisle
