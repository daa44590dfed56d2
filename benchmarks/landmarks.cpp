/// One image in maps of a hundred to a million landmarks: localisation (LandmarkLocaliser) and relocalisation
/// after kidnapping (LandmarkRelocator). Both should cost the same in any building; `times_small` is the
/// ratio of the median to that of the smallest map in the same run.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <map>
#include <string>
#include <vector>

#include "aisle/learning/landmarks/landmark_relocation.hpp"
#include "corridor_run.hpp"

namespace aisle {
namespace {

constexpr double kCorridor_m = 25, kApart_m = 6, kTried_m = 0.8;
constexpr int kImages = 200;

/// Corridors side by side, with as many landmarks as asked for.
struct ManyCorridors {
  LandmarkMap map;
  std::vector<CorridorLine> lines;  ///< of the corridor in the middle
  Pose2 T_map_middle;
  std::vector<Pose2> T_map_tried;
};

ManyCorridors corridors_with(std::size_t landmarks) {
  Random random(1);
  std::vector<std::vector<CorridorLine>> corridors;
  for (std::size_t lines = 0; lines < landmarks; lines += corridors.back().size()) {
    corridors.push_back(corridor_lines(kCorridor_m, random));
    for (CorridorLine& line : corridors.back())
      line.p_map.y() += kApart_m * static_cast<double>(corridors.size() - 1);
  }
  ManyCorridors many;
  for (std::size_t i = 0; i < corridors.size(); ++i) {
    const LandmarkMap corridor = map_of(corridors[i]);
    for (const Landmark& landmark : corridor.all()) many.map.add(landmark);
    for (double x = 0; x < kCorridor_m; x += kTried_m)
      many.T_map_tried.push_back({x, kApart_m * static_cast<double>(i), 0});
  }
  const std::size_t middle = corridors.size() / 2;
  many.lines = corridors[middle];
  many.T_map_middle = {kCorridor_m / 2, kApart_m * static_cast<double>(middle), 0};
  return many;
}

double thread_cpu_now_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Medians of the smallest maps, by the quantity that was measured.
std::map<std::string, double>& smallest_s() {
  static std::map<std::string, double> medians;
  return medians;
}

template <class TakeIn>
void measure(benchmark::State& state, const std::string& name, const ManyCorridors& many, TakeIn take_in) {
  Random random(2);
  std::vector<double> times_s;
  for (auto _ : state) {
    for (int i = 0; i < kImages; ++i) {
      const auto sightings = sightings_from(many.lines, many.T_map_middle, {}, &random);
      const double begun_s = thread_cpu_now_s();
      take_in(sightings);
      times_s.push_back(thread_cpu_now_s() - begun_s);
    }
  }
  std::sort(times_s.begin(), times_s.end());
  const double median_s = times_s[times_s.size() / 2];
  const double small_s = smallest_s().try_emplace(name, median_s).first->second;
  state.counters["landmarks"] = static_cast<double>(many.map.size());
  state.counters["median_ms"] = 1e3 * median_s;
  state.counters["p99_ms"] = 1e3 * times_s[times_s.size() * 99 / 100];
  state.counters["times_small"] = median_s / small_s;
}

void localise(benchmark::State& state) {
  const ManyCorridors many = corridors_with(static_cast<std::size_t>(state.range(0)));
  LandmarkLocaliser localiser({}, corridor_cart(), {});
  measure(state, "localise", many, [&](const std::vector<LandmarkSighting>& sightings) {
    localiser.place(about(many.T_map_middle, 0.1, 2 * kDegree));
    benchmark::DoNotOptimize(localiser.correct(many.map, sightings));
  });
}

void relocate(benchmark::State& state) {
  const ManyCorridors many = corridors_with(static_cast<std::size_t>(state.range(0)));
  LandmarkRelocator relocator({}, {}, corridor_cart(), many.T_map_tried);
  measure(state, "relocate", many, [&](const std::vector<LandmarkSighting>& sightings) {
    benchmark::DoNotOptimize(relocator.look(many.map, sightings));
  });
}

BENCHMARK(localise)->Arg(100)->Arg(10'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(relocate)->Arg(100)->Arg(10'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace aisle
