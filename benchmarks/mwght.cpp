/// The generalised Hough transform of C98 by branch and bound, compared with the published voting in the same
/// run and with the same answer: on simulated corridors of door frames with clutter. The counter
/// `times_faster` is the ratio of the mean times; `same_answers` must be 1.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "aisle/matching/mwght.hpp"
#include "corridor_points.hpp"

namespace aisle {
namespace {

constexpr int kCorridors = 50;

struct Case {
  MwghtParams params;
  MwghtWindow window;
  CorridorSight sight;
};

/// The window of the published comparison: 2 m x 2 m x 10 degrees by 1 cm and 0.25 degrees.
Case wide() {
  return {{.cell_m = 0.01}, {1, 1, 5 * kDegree}, {.learned = 60, .seen = 30, .off = {0.8, 0.3, 4 * kDegree}}};
}

/// Tracking from one image to the next.
Case driving() {
  return {{}, {0.25, 0.25, 2 * kDegree}, {.learned = 45, .seen = 15, .off = {0.15, 0.08, 1 * kDegree}}};
}

/// Relocalisation: 4 m x 4 m x 40 degrees among 100 learned points.
Case lost() {
  return {{}, {2, 2, 20 * kDegree}, {.learned = 100, .seen = 25, .off = {1.6, 0.4, 15 * kDegree}}};
}

std::vector<CorridorPoints> corridors(const CorridorSight& sight) {
  Random random(1);
  std::vector<CorridorPoints> all;
  for (int i = 0; i < kCorridors; ++i) all.push_back(corridor_points(sight, random));
  return all;
}

/// The largest H by Algorithm 1 as printed, angle by angle.
double vote_as_printed(const Case& tried, const CorridorPoints& points) {
  const MwghtParams& params = tried.params;
  const auto half = [](double size, double step) { return static_cast<int>(size / step + 1e-9); };
  const int half_x = half(tried.window.x_half_m, params.cell_m),
            half_y = half(tried.window.y_half_m, params.cell_m);
  const int half_turn = half(tried.window.turn_half_rad, params.angle_step_rad);
  const int reach = half(params.reach_m, params.cell_m), columns = 2 * half_x + 1;
  std::vector<double> cells;
  double greatest = 0;
  for (int turn = -half_turn; turn <= half_turn; ++turn) {
    cells.assign(static_cast<std::size_t>(columns * (2 * half_y + 1)), 0.0);
    for (const WeightedPoint& q : points.seen) {
      const Vec2 turned = rotate(turn * params.angle_step_rad, q.position);
      for (const WeightedPoint& p : points.learned) {
        const Vec2 d = (p.position - turned) / params.cell_m;
        const int x0 = static_cast<int>(std::lround(d.x())), y0 = static_cast<int>(std::lround(d.y()));
        for (int y = std::max(-half_y, y0 - reach); y <= std::min(half_y, y0 + reach); ++y) {
          for (int x = std::max(-half_x, x0 - reach); x <= std::min(half_x, x0 + reach); ++x) {
            const double d1_m = params.cell_m * std::sqrt((x - x0) * (x - x0) + (y - y0) * (y - y0));
            const double share = d1_m <= params.reach_m ? 1 / (1 + d1_m / params.distance_scale_m) : 0;
            cells[static_cast<std::size_t>((y + half_y) * columns + x + half_x)] +=
                p.weight * q.weight * share;
          }
        }
      }
    }
    greatest = std::max(greatest, *std::max_element(cells.begin(), cells.end()));
  }
  return greatest;
}

bool same(const std::optional<MwghtPeak>& a, const std::optional<MwghtPeak>& b) {
  return a.has_value() == b.has_value() && (!a || (a->cell == b->cell && a->value == b->value));
}

bool same(const std::optional<MwghtAnswer>& a, const std::optional<MwghtAnswer>& b) {
  return a && b && same(a->best, b->best) && same(a->runner_up, b->runner_up);
}

double cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Match>
std::vector<double> seconds(const std::vector<CorridorPoints>& all, Match match) {
  std::vector<double> times;
  for (const CorridorPoints& points : all) {
    const double start = cpu_s();
    benchmark::DoNotOptimize(match(points));
    times.push_back(cpu_s() - start);
  }
  return times;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void compare(benchmark::State& state, const Case& tried) {
  const std::vector<CorridorPoints> all = corridors(tried.sight);
  Mwght mwght(tried.params);
  const auto by_bounds = [&](const CorridorPoints& c) {
    return mwght.match(c.learned, c.seen, tried.window);
  };
  const auto by_voting = [&](const CorridorPoints& c) {
    return mwght.match_exhaustively(c.learned, c.seen, tried.window);
  };
  for (auto _ : state) {
    for (const CorridorPoints& points : all) benchmark::DoNotOptimize(by_bounds(points));
  }
  const std::vector<double> fast = seconds(all, by_bounds), slow = seconds(all, by_voting);
  const auto printed = seconds(all, [&](const CorridorPoints& c) { return vote_as_printed(tried, c); });
  int agreeing = 0, found = 0;
  for (const CorridorPoints& points : all) {
    const auto answer = by_bounds(points);
    agreeing += same(answer, by_voting(points)) ? 1 : 0;
    const Pose2 error = between(points.truth, answer->best.displacement);
    found += error.position().norm() < 0.05 && std::abs(error.theta) < 1 * kDegree ? 1 : 0;
  }
  state.counters["median_ms"] = 1e3 * quantile(fast, 0.5);
  state.counters["p99_ms"] = 1e3 * quantile(fast, 0.99);
  state.counters["voting_ms"] = 1e3 * quantile(slow, 0.5);
  state.counters["times_faster"] = mean(slow) / mean(fast);
  state.counters["times_printed"] = mean(printed) / mean(fast);
  state.counters["same_answers"] = static_cast<double>(agreeing) / kCorridors;
  state.counters["found"] = static_cast<double>(found) / kCorridors;
}

BENCHMARK_CAPTURE(compare, wide, wide())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(compare, driving, driving())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(compare, lost, lost())->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace aisle
