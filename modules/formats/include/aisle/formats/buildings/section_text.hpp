#pragma once
/// Sections as text that people read and edit, one per line; see docs/formats/sections.md.

#include <string>
#include <string_view>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/maps/section.hpp"

namespace aisle {

/// "a 5.312 right 0.402 left 0.898", "r 36", "c 0.424 0.6"
std::string section_text(const Section& section);

/// Reads such a line. Problems carry no file or line: the caller adds them.
Result<Section> parse_section(std::string_view line);

/// A section that cannot be driven in this order: a list of turns only, a hybrid section without a right turn
/// after it, a dead-reckoned section without turns at both ends, a turn right after a turn.
struct SectionFault {
  std::size_t section = 0;
  std::string what;
};
std::vector<SectionFault> section_faults(const SectionList& sections);

}  // namespace aisle
