#pragma once
/// Sections as people read and edit them, one a line. docs/formats/sections.md specifies the lines.

#include <string>
#include <string_view>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/maps/section.hpp"

namespace aisle {

/// "a 5.312 right 0.402 left 0.898", "r 36", "c 0.424 0.6"
std::string section_text(const Section& section);

/// Reads such a line; problems have no place.
Result<Section> parse_section(std::string_view line);

/// What cannot be driven in this order: no path at all, a hybrid section that no right turn follows, a path
/// across without turns at both ends, turns that follow each other.
struct SectionFault {
  std::size_t section = 0;
  std::string what;
};
std::vector<SectionFault> section_faults(const SectionList& sections);

}  // namespace aisle
