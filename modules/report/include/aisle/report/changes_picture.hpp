#pragma once

#include <string>

#include "aisle/merging/building_changes.hpp"

namespace aisle {

/// What has changed between two maps: walls that both have, new, gone and moved ones, doors that were shut or
/// opened, floor won and lost, and what only one of the maps has seen. In the old map's frame; y up, the
/// longer side 1600 px.
struct ChangesPicture {
  const BuildingChanges& changes;
  std::string title = {};
  std::string caption = {};  ///< one line below the title
};

/// The picture as an SVG document. Same picture, same bytes.
std::string svg(const ChangesPicture& picture);

/// The picture as a PNG file. Same picture, same bytes.
std::string png(const ChangesPicture& picture);

}  // namespace aisle
