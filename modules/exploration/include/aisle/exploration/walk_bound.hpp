#pragma once

#include <cstddef>
#include <optional>

#include "aisle/exploration/grid_world.hpp"

namespace aisle {

/// A lower bound of the moves in which any walk, even with a map, can visit every reachable cell and return.
///
/// Articulation cells divide the world into blocks that are walked independently. Inside a block, black and
/// white cells alternate as on a chessboard, so that each cell of the more frequent colour costs two moves.
/// Exact for trees.
std::size_t walk_lower_bound(const GridWorld& world, Cell start);

/// The moves of the shortest walk that visits every reachable cell and returns; nullopt for more than
/// kMaxExactCells reachable cells.
std::optional<std::size_t> shortest_walk(const GridWorld& world, Cell start);

inline constexpr std::size_t kMaxExactCells = 16;

}  // namespace aisle
