/// The cost of a move through the transducer's table, compared with a hand-written depth-first step in the
/// same run.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "aisle/exploration/grid_explorer.hpp"
#include "aisle/exploration/maze_generator.hpp"

namespace aisle {
namespace {

/// Enough different worlds that branch prediction cannot learn their turns.
std::vector<GridWorld> worlds_of(int size) {
  std::vector<GridWorld> worlds;
  const std::uint64_t count = std::max(1, (1 << 20) / (size * size) / 4);
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    worlds.push_back(
        generate_maze({.kind = MazeKind::kBraided, .width = size, .height = size}, Random(seed)));
  }
  return worlds;
}

/// Depth first over cells, with a stack of the sides to go back by: what one would write for this world
/// alone. It builds the same map.
std::size_t depth_first_moves(const GridWorld& world) {
  LearnedGrid map(world.width(), world.height());
  std::vector<Side> back;
  std::size_t at = world.index(world.start);
  std::size_t moves = 0;
  map.see(at, world.open(at));
  while (true) {
    const Sides open = map.open(at);
    bool advanced = false;
    for (const Side side : kAllSides) {
      if (!contains(open, side)) continue;
      const std::size_t next = map.neighbour(at, side);
      if (map.visited(next)) continue;
      at = next;
      map.see(at, world.open(at));
      back.push_back(opposite(side));
      advanced = true;
      break;
    }
    if (!advanced) {
      if (back.empty()) return moves;
      at = map.neighbour(at, back.back());
      back.pop_back();
    }
    ++moves;
  }
}

std::size_t transducer_moves(const GridWorld& world, GridRuleSet set) {
  GridExplorer explorer(grid_rules(set), world.width(), world.height(), world.start);
  std::size_t moves = 0;
  while (explorer.step(world.open(explorer.at_index()))) ++moves;
  return moves;
}

template <class Moves>
double ns_a_move(const std::vector<GridWorld>& worlds, Moves moves_in) {
  constexpr int kRounds = 3;
  std::size_t moves = 0;
  const auto start = std::chrono::steady_clock::now();
  for (int round = 0; round < kRounds; ++round) {
    for (const GridWorld& world : worlds) moves += moves_in(world);
  }
  const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - start;
  return spent.count() / static_cast<double>(moves);
}

template <class Moves>
void compare(benchmark::State& state, Moves moves_in) {
  const std::vector<GridWorld> worlds = worlds_of(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    for (const GridWorld& world : worlds) benchmark::DoNotOptimize(moves_in(world));
  }
  const double own_ns = ns_a_move(worlds, moves_in);
  state.counters["ns_a_move"] = own_ns;
  state.counters["times_hand_written"] = own_ns / ns_a_move(worlds, depth_first_moves);
}

void BM_HandWrittenDepthFirst(benchmark::State& state) {
  compare(state, depth_first_moves);
}
void BM_Transducer(benchmark::State& state, GridRuleSet set) {
  compare(state, [set](const GridWorld& world) { return transducer_moves(world, set); });
}

/// Cells per side of the world.
void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(16)->Arg(256)->Unit(benchmark::kMillisecond);
}

BENCHMARK(BM_HandWrittenDepthFirst)->Apply(sizes);
BENCHMARK_CAPTURE(BM_Transducer, published, GridRuleSet::kPublished)->Apply(sizes);
BENCHMARK_CAPTURE(BM_Transducer, shortcut, GridRuleSet::kShortcut)->Apply(sizes);
BENCHMARK_CAPTURE(BM_Transducer, cells, GridRuleSet::kCells)->Apply(sizes);
BENCHMARK_CAPTURE(BM_Transducer, homing, GridRuleSet::kHoming)->Apply(sizes);
BENCHMARK_CAPTURE(BM_Transducer, roaming, GridRuleSet::kRoaming)->Apply(sizes);

}  // namespace
}  // namespace aisle
