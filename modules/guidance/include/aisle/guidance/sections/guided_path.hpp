#pragma once
/// The path of a list of sections, and what each piece of it is driven by.

#include <optional>
#include <vector>

#include "aisle/control/path.hpp"
#include "aisle/maps/section.hpp"

namespace aisle {

/// What a piece of a path is driven by.
struct SectionGuide {
  std::size_t section = 0;  ///< of the list
  bool follows = false;     ///< along a base line, at these distances
  std::optional<double> right_m;
  std::optional<double> left_m;
  std::optional<double> ahead_m;      ///< from the piece's end to the wall across it
  std::optional<double> line_ends_m;  ///< the base line inside of the turn that follows ends so far before
                                      ///< the piece's end
  bool turns_right = false;           ///< the turn that follows
};

struct GuidedPath {
  Path path;
  std::vector<SectionGuide> guides;  ///< one a piece
  bool comes_home = false;           ///< it ends as it begins
};

enum class SectionRun { kThere, kBack, kThereAndBack };

/// The path of a list; back, the vehicle turned about, right and left change places. Home again it turns
/// about once more, and looks along the path as it did at first. Where two sections that follow base lines
/// meet at a corner, the base lines of the one are the wall across the other and the end of its base line.
GuidedPath guided_path(const SectionList& sections, const Pose2& T_map_start, SectionRun run);

}  // namespace aisle
