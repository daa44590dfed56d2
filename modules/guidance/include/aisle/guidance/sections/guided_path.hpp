#pragma once
/// The path of a list of sections, and what guides the vehicle on each piece of it.

#include <optional>
#include <vector>

#include "aisle/control/path.hpp"
#include "aisle/maps/section.hpp"

namespace aisle {

/// What guides the vehicle on a piece of a path.
struct SectionGuide {
  std::size_t section = 0;  ///< index in the list
  bool follows = false;     ///< follows base lines, at these distances
  std::optional<double> right_m;
  std::optional<double> left_m;
  std::optional<double> ahead_m;      ///< from the piece's end to the wall across it
  std::optional<double> line_ends_m;  ///< from the end of the next turn's inner base line to the piece's end
  bool turns_right = false;           ///< direction of the next turn
};

struct GuidedPath {
  Path path;
  std::vector<SectionGuide> guides;  ///< one per piece
  bool comes_home = false;           ///< it ends as it begins
};

enum class SectionRun { kThere, kBack, kThereAndBack };

/// The path of a list. On the way back right and left are swapped, as the vehicle has turned about; home
/// again it turns about once more, so that it faces along the path as at first. Where two sections that
/// follow base lines meet at a corner, the base lines of one give the other its wall ahead and the end of its
/// base line.
GuidedPath guided_path(const SectionList& sections, const Pose2& T_map_start, SectionRun run);

}  // namespace aisle
