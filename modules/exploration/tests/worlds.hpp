#pragma once
/// Worlds for tests: drawn by hand, all of one size, or random.

#include <rapidcheck.h>

#include <string>
#include <vector>

#include "aisle/exploration/maze_generator.hpp"

namespace aisle {

/// A world from the open sides of its cells, row by row from the top: "r lr l" is a corridor of three cells.
inline GridWorld world_of(const std::vector<std::vector<std::string>>& rows) {
  GridWorld world(static_cast<int>(rows.front().size()), static_cast<int>(rows.size()));
  for (int y = 0; y < world.height(); ++y) {
    for (int x = 0; x < world.width(); ++x) {
      const std::string& open =
          rows[static_cast<std::size_t>(world.height() - 1 - y)][static_cast<std::size_t>(x)];
      if (open.find('r') != std::string::npos) world.set_open({x, y}, Side::kRight, true);
      if (open.find('t') != std::string::npos) world.set_open({x, y}, Side::kTop, true);
    }
  }
  return world;
}

inline std::size_t inner_edges(int width, int height) {
  return static_cast<std::size_t>((width - 1) * height + width * (height - 1));
}

/// The world whose inner edges are open where `bits` has a 1.
inline GridWorld world_from_bits(int width, int height, std::uint64_t bits) {
  GridWorld world(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (x + 1 < width) {
        if (bits & 1) world.set_open({x, y}, Side::kRight, true);
        bits >>= 1;
      }
      if (y + 1 < height) {
        if (bits & 1) world.set_open({x, y}, Side::kTop, true);
        bits >>= 1;
      }
    }
  }
  return world;
}

/// Any kind of world, with or without walls added at random, and any start.
inline GridWorld random_world(int max_size) {
  MazeRecipe recipe;
  recipe.kind = *rc::gen::elementOf(std::vector<MazeKind>(std::begin(kMazeKinds), std::end(kMazeKinds)));
  recipe.width = *rc::gen::inRange(1, max_size + 1);
  recipe.height = *rc::gen::inRange(1, max_size + 1);
  recipe.loop_share = *rc::gen::inRange(0, 11) / 10.0;
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  GridWorld world = generate_maze(recipe, random);
  const double closed_share = *rc::gen::element(0.0, 0.1, 0.3);
  for (int y = 0; y < world.height(); ++y) {
    for (int x = 0; x < world.width(); ++x) {
      if (x + 1 < world.width() && random.uniform() < closed_share)
        world.set_open({x, y}, Side::kRight, false);
      if (y + 1 < world.height() && random.uniform() < closed_share)
        world.set_open({x, y}, Side::kTop, false);
    }
  }
  world.start = {*rc::gen::inRange(0, world.width()), *rc::gen::inRange(0, world.height())};
  return world;
}

}  // namespace aisle
