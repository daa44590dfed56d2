/// One view matched against a window of the map: aisle's signature match of C99 Algorithm 2, compared with
/// the same algorithm cell by cell and with exhaustive 2-D correlation of the same segments. All three search
/// the same displacements of +-0.4 m in steps of 2 cm. The counter `times_signature` is the ratio to the
/// first.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "aisle/core/random.hpp"
#include "aisle/matching/signature.hpp"

namespace aisle {
namespace {

constexpr SignatureParams kParams;
constexpr int kHalf = 20;

/// The inner walls of six by six rooms of about 4 m, and a view of six of them.
struct Scene {
  std::vector<Segment2> window;
  std::vector<Segment2> view;
};

constexpr double kShiftX_m = 0.12, kShiftY_m = -0.08;

Scene office() {
  Random random(1);
  Scene scene;
  for (int room = 0; room < 36; ++room) {
    const Vec2 corner(4.0 * (room % 6) + random.uniform(0.1, 0.5),
                      4.0 * (room / 6) + random.uniform(0.1, 0.5));
    const Vec2 size(random.uniform(2.8, 3.4), random.uniform(2.8, 3.4));
    const Vec2 a = corner, b = corner + Vec2(size.x(), 0), c = corner + size, d = corner + Vec2(0, size.y());
    for (const Segment2& wall : {Segment2{a, b}, Segment2{b, c}, Segment2{c, d}, Segment2{d, a}}) {
      scene.window.push_back(wall);
      const Vec2 shift(kShiftX_m, kShiftY_m);
      if (room % 6 < 3 && room / 6 < 2) scene.view.push_back({wall.start + shift, wall.end + shift});
    }
  }
  return scene;
}

Signature signature_of(const std::vector<Segment2>& segments, const Vec2& axis) {
  Signature signature;
  for (const Segment2& s : segments) mark({s, s.length(), 0.3, 0.3}, axis, SymbolKinds::kByFacing, signature);
  return signature;
}

Vec2 match_by_signatures(const Scene& scene, SignatureCorrelator& correlator) {
  Vec2 displacement;
  for (const Eigen::Index axis : {0, 1}) {
    const Vec2 direction = Vec2::Unit(axis);
    Signature learned = signature_of(scene.window, direction);
    sort_symbols(learned);
    correlator.correlate(signature_of(scene.view, direction), learned);
    displacement[axis] = correlator.peak_m().value_or(0);
  }
  return displacement;
}

/// Steps 1 to 6 of the algorithm as printed, on arrays of cells.
Vec2 match_cell_by_cell(const Scene& scene) {
  constexpr int kCells = 2000;
  const auto blurred = [](const Signature& signature) {
    std::vector<double> raw(kCells, 0.0), smooth(kCells, 0.0);
    for (const SignatureSymbol& s : signature) {
      raw[static_cast<std::size_t>(std::lround(s.position_m / kParams.cell_m) + kCells / 2)] += s.weight;
    }
    for (int x = 5; x + 5 < kCells; ++x) {
      for (int i = -5; i <= 5; ++i) {
        smooth[static_cast<std::size_t>(x)] +=
            raw[static_cast<std::size_t>(x + i)] / (1 + std::abs(i) / kParams.tolerance);
      }
    }
    return smooth;
  };
  Vec2 displacement = Vec2::Zero();
  for (const Eigen::Index axis : {0, 1}) {
    const auto n = blurred(signature_of(scene.view, Vec2::Unit(axis)));
    const auto l = blurred(signature_of(scene.window, Vec2::Unit(axis)));
    double best = -1;
    for (int d = -kHalf; d <= kHalf; ++d) {
      double value = 0;
      for (int x = kHalf; x + kHalf < kCells; ++x)
        value += n[static_cast<std::size_t>(x)] * l[static_cast<std::size_t>(x + d)];
      if (value > best) {
        best = value;
        displacement[axis] = d * kParams.cell_m;
      }
    }
  }
  return displacement;
}

/// The length of the view that lies on the window's walls, for every displacement in the plane.
Vec2 match_exhaustively(const Scene& scene) {
  Vec2 displacement = Vec2::Zero();
  double best = -1;
  for (int i = -kHalf; i <= kHalf; ++i) {
    for (int j = -kHalf; j <= kHalf; ++j) {
      const Vec2 shift(i * kParams.cell_m, j * kParams.cell_m);
      double value = 0;
      for (const Segment2& s : scene.view) {
        const bool along_x = s.start.y() == s.end.y();
        const Eigen::Index along = along_x ? 0 : 1;
        for (const Segment2& wall : scene.window) {
          if ((wall.start.y() == wall.end.y()) != along_x) continue;
          const double across_m = std::abs(s.start[1 - along] + shift[1 - along] - wall.start[1 - along]);
          const bool same_facing = (s.end[along] > s.start[along]) == (wall.end[along] > wall.start[along]);
          if (!same_facing) continue;
          const double from = s.start[along] + shift[along], to = s.end[along] + shift[along];
          const double overlap_m =
              std::min(std::max(from, to), std::max(wall.start[along], wall.end[along])) -
              std::max(std::min(from, to), std::min(wall.start[along], wall.end[along]));
          if (across_m < 0.1 && overlap_m > 0)
            value += overlap_m / (1 + across_m / (kParams.tolerance * kParams.cell_m));
        }
      }
      if (value > best) {
        best = value;
        displacement = shift;
      }
    }
  }
  return displacement;
}

template <class Match>
double seconds_per_call(Match match, int calls) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < calls; ++i) benchmark::DoNotOptimize(match());
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / calls;
}

template <class Match>
void compare(benchmark::State& state, Match match) {
  const Scene scene = office();
  SignatureCorrelator correlator(kParams);
  for (auto _ : state) benchmark::DoNotOptimize(match(scene));
  const double baseline_s = seconds_per_call([&] { return match_by_signatures(scene, correlator); }, 200);
  state.counters["times_signature"] = seconds_per_call([&] { return match(scene); }, 5) / baseline_s;
  state.counters["off_m"] = (match(scene) + Vec2(kShiftX_m, kShiftY_m)).norm();
}

void BM_Signature(benchmark::State& state) {
  SignatureCorrelator correlator(kParams);
  compare(state, [&](const Scene& scene) { return match_by_signatures(scene, correlator); });
}
void BM_CellByCell(benchmark::State& state) {
  compare(state, match_cell_by_cell);
}
void BM_Exhaustive2D(benchmark::State& state) {
  compare(state, match_exhaustively);
}

BENCHMARK(BM_Signature)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_CellByCell)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Exhaustive2D)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace aisle
