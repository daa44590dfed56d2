#include "aisle/exploration/maze_generator.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace aisle {
namespace {

constexpr std::array<std::string_view, 6> kMazeKindNames = {"perfect", "braided", "rooms",
                                                            "spiral",  "comb",    "hall"};

/// Depth-first, always to a random unvisited neighbour: gives long winding corridors.
void carve_tree(GridWorld& world, Random& random) {
  std::vector<bool> carved(world.size(), false);
  std::vector<std::uint32_t> path{0};
  carved[0] = true;
  while (!path.empty()) {
    const Cell cell = world.cell(path.back());
    std::array<Side, 4> sides{};
    std::size_t count = 0;
    for (const Side side : kAllSides) {
      const Cell next = neighbour(cell, side);
      if (world.contains(next) && !carved[world.index(next)]) sides[count++] = side;
    }
    if (count == 0) {
      path.pop_back();
      continue;
    }
    const Side side = sides[random.index(count)];
    world.set_open(cell, side, true);
    path.push_back(static_cast<std::uint32_t>(world.index(neighbour(cell, side))));
    carved[path.back()] = true;
  }
}

void open_dead_ends(GridWorld& world, double share, Random& random) {
  for (std::size_t i = 0; i < world.size(); ++i) {
    if (std::popcount(static_cast<unsigned>(world.open(i))) != 1 || random.uniform() >= share) continue;
    const Cell cell = world.cell(i);
    std::array<Side, 4> sides{};
    std::size_t count = 0;
    for (const Side side : kAllSides) {
      if (world.contains(neighbour(cell, side)) && !contains(world.open(i), side)) sides[count++] = side;
    }
    if (count > 0) world.set_open(cell, sides[random.index(count)], true);
  }
}

void clear_room(GridWorld& world, Cell corner, int width, int height) {
  for (int y = corner.y; y < corner.y + height; ++y) {
    for (int x = corner.x; x < corner.x + width; ++x) {
      if (x + 1 < corner.x + width) world.set_open({x, y}, Side::kRight, true);
      if (y + 1 < corner.y + height) world.set_open({x, y}, Side::kTop, true);
    }
  }
}

int random_between(int min, int max, Random& random) {
  const auto count = static_cast<std::uint64_t>(max - min) + 1;
  return min + static_cast<int>(random.index(count));
}

void clear_rooms(GridWorld& world, Random& random) {
  constexpr std::size_t kCellsPerRoom = 40;
  for (std::size_t room = 0; room < world.size() / kCellsPerRoom + 1; ++room) {
    const int width = std::min(world.width(), random_between(2, 6, random));
    const int height = std::min(world.height(), random_between(2, 6, random));
    const Cell corner{random_between(0, world.width() - width, random),
                      random_between(0, world.height() - height, random)};
    clear_room(world, corner, width, height);
  }
}

void carve_spiral(GridWorld& world) {
  constexpr std::array<Side, 4> kTurns = {Side::kTop, Side::kRight, Side::kBottom, Side::kLeft};
  std::vector<bool> carved(world.size(), false);
  Cell cell;
  carved[0] = true;
  std::size_t blocked_turns = 0;
  for (std::size_t turn = 0; blocked_turns < 2;) {
    const Side side = kTurns[turn % 4];
    const Cell next = neighbour(cell, side);
    if (!world.contains(next) || carved[world.index(next)]) {
      ++turn;
      ++blocked_turns;
      continue;
    }
    blocked_turns = 0;
    world.set_open(cell, side, true);
    cell = next;
    carved[world.index(cell)] = true;
  }
}

void carve_comb(GridWorld& world, Random& random) {
  for (int x = 0; x < world.width(); ++x) {
    if (x + 1 < world.width()) world.set_open({x, 0}, Side::kRight, true);
    const int length = random_between(0, world.height() - 1, random);
    for (int y = 0; y < length; ++y) world.set_open({x, y}, Side::kTop, true);
  }
}

}  // namespace

std::string_view name_of(MazeKind kind) {
  return kMazeKindNames[static_cast<std::size_t>(kind)];
}

std::optional<MazeKind> maze_kind(std::string_view name) {
  for (const MazeKind kind : kMazeKinds) {
    if (name_of(kind) == name) return kind;
  }
  return std::nullopt;
}

Problems MazeRecipe::problems() const {
  Problems problems;
  const auto check_size = [&](const char* key, int value) {
    if (value >= 1 && value <= GridShape::kMaxSize) return;
    problems.push_back(
        {{.key = key}, std::to_string(value) + " is not in 1 .. " + std::to_string(GridShape::kMaxSize)});
  };
  check_size("width", width);
  check_size("height", height);
  if (!(loop_share >= 0 && loop_share <= 1)) {
    problems.push_back({{.key = "loops"}, std::to_string(loop_share) + " is not in 0 .. 1"});
  }
  return problems;
}

GridWorld generate_maze(const MazeRecipe& recipe, Random random) {
  GridWorld world(recipe.width, recipe.height);
  world.goals = middle_cells(world);
  switch (recipe.kind) {
    case MazeKind::kPerfect:
      carve_tree(world, random);
      break;
    case MazeKind::kBraided:
      carve_tree(world, random);
      open_dead_ends(world, recipe.loop_share, random);
      break;
    case MazeKind::kRooms:
      carve_tree(world, random);
      clear_rooms(world, random);
      break;
    case MazeKind::kSpiral:
      carve_spiral(world);
      break;
    case MazeKind::kComb:
      carve_comb(world, random);
      break;
    case MazeKind::kHall:
      world.open_all();
      break;
  }
  return world;
}

std::vector<Cell> middle_cells(const GridShape& shape) {
  std::vector<Cell> cells;
  for (int y = (shape.height() - 1) / 2; y <= shape.height() / 2; ++y) {
    for (int x = (shape.width() - 1) / 2; x <= shape.width() / 2; ++x) cells.push_back({x, y});
  }
  return cells;
}

}  // namespace aisle
