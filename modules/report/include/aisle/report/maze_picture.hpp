#pragma once

#include <string>

#include "aisle/core/problem.hpp"
#include "aisle/exploration/grid_rules.hpp"

namespace aisle {

/// A run through a world in the style of C97's Figure 6: the world with the vehicle's actions, the learned
/// map beside it. The run starts at `world.start`.
struct MazePicture {
  static constexpr int kMaxSize = 256;

  const GridWorld& world;
  GridRuleSet rules = GridRuleSet::kPublished;
  std::string title = {};

  Problems problems() const;  ///< more than kMaxSize columns or rows
};

/// The whole run with the vehicle's trace. Same picture, same bytes.
std::string svg(const MazePicture& picture);

/// The run as an animation of at most some 500 frames, however long it is.
std::string gif(const MazePicture& picture);

}  // namespace aisle
