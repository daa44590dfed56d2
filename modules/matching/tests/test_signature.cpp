#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "aisle/core/random.hpp"
#include "aisle/matching/signature.hpp"

namespace aisle {
namespace {

/// A pattern of axis-parallel walls.
std::vector<Segment2> any_pattern(Random& random) {
  std::vector<Segment2> pattern;
  const std::uint64_t count = 3 + random.index(12);
  for (std::uint64_t i = 0; i < count; ++i) {
    const Vec2 start(random.uniform(-10, 10), random.uniform(-10, 10));
    const double length_m = random.uniform(0.5, 5);
    pattern.push_back({start, start + (random.uniform() < 0.5 ? Vec2(length_m, 0) : Vec2(0, length_m))});
  }
  return pattern;
}

Signature signature_of(const std::vector<Segment2>& pattern, const Vec2& axis, SymbolKinds kinds,
                       const Vec2& shift = Vec2::Zero()) {
  Signature signature;
  for (const Segment2& s : pattern) {
    mark({{s.start + shift, s.end + shift}, s.length(), 0.3, 0.3}, axis, kinds, signature);
  }
  return signature;
}

/// Steps 4 and 5 of Algorithm 2 cell by cell, as printed (with the bars of the settled formula).
std::vector<double> correlate_cell_by_cell(const Signature& sensed, const Signature& learned,
                                           const SignatureParams& params) {
  const int half = static_cast<int>(std::ceil(params.reach_m / params.cell_m));
  const int cells = 4000;
  const auto blurred = [&](const Signature& signature) {
    std::vector<double> raw(cells, 0.0), blurred_cells(cells, 0.0);
    for (const SignatureSymbol& s : signature) {
      raw[static_cast<std::size_t>(std::lround(s.position_m / params.cell_m) + cells / 2)] += s.weight;
    }
    for (int x = 0; x < cells; ++x) {
      for (int i = -params.neighbourhood / 2; i <= params.neighbourhood / 2; ++i) {
        if (x + i < 0 || x + i >= cells) continue;
        blurred_cells[static_cast<std::size_t>(x)] +=
            raw[static_cast<std::size_t>(x + i)] / (1 + std::abs(i) / params.tolerance);
      }
    }
    return blurred_cells;
  };
  const std::vector<double> n = blurred(sensed), l = blurred(learned);
  std::vector<double> values(static_cast<std::size_t>(2 * half + 1), 0.0);
  for (int d = -half; d <= half; ++d) {
    for (int x = 0; x < cells; ++x) {
      if (x + d >= 0 && x + d < cells) {
        values[static_cast<std::size_t>(d + half)] +=
            n[static_cast<std::size_t>(x)] * l[static_cast<std::size_t>(x + d)];
      }
    }
  }
  return values;
}

RC_GTEST_PROP(Signature, PairwiseCorrelationEqualsTheBlurredCellsOfTheAlgorithm, (std::uint64_t seed)) {
  Random random(seed);
  SignatureParams params;
  const auto on_cells = [&](Signature signature) {  // symbols on cell centres: no rounding in between
    for (SignatureSymbol& s : signature)
      s.position_m = std::round(s.position_m / params.cell_m) * params.cell_m;
    return signature;
  };
  const Signature sensed = on_cells(signature_of(any_pattern(random), Vec2::UnitX(), SymbolKinds::kOne));
  Signature learned = on_cells(signature_of(any_pattern(random), Vec2::UnitX(), SymbolKinds::kOne));
  const std::vector<double> expected = correlate_cell_by_cell(sensed, learned, params);
  sort_symbols(learned);
  SignatureCorrelator correlator(params);
  const std::span<double> values = correlator.correlate(sensed, learned);
  RC_ASSERT(values.size() == expected.size());
  for (std::size_t i = 0; i < values.size(); ++i) RC_ASSERT(std::abs(values[i] - expected[i]) < 1e-6);
}

RC_GTEST_PROP(Signature, FindsTheExactCellOfAnyInjectedShift, (std::uint64_t seed)) {
  Random random(seed);
  SignatureParams params;
  const std::vector<Segment2> pattern = any_pattern(random);
  const int cells_x = static_cast<int>(random.index(39)) - 19,
            cells_y = static_cast<int>(random.index(39)) - 19;
  const Vec2 shift(cells_x * params.cell_m, cells_y * params.cell_m);
  SignatureCorrelator correlator(params);
  for (const Vec2& axis : {Vec2(1, 0), Vec2(0, 1)}) {
    for (const SymbolKinds kinds : {SymbolKinds::kOne, SymbolKinds::kByFacing}) {
      Signature learned = signature_of(pattern, axis, kinds);
      sort_symbols(learned);
      correlator.correlate(signature_of(pattern, axis, kinds, -shift), learned);
      const auto found_m = correlator.peak_m();
      RC_ASSERT(found_m.has_value());
      RC_ASSERT(std::abs(*found_m - axis.dot(shift)) < params.cell_m / 2);  // the exact cell
    }
  }
}

TEST(Signature, OnlyWallsThatFaceTheSameWaySupportEachOther) {
  const Segment2 wall{{0, 1}, {3, 1}};
  Signature sensed, learned;
  mark({wall, 3, 0, 0}, Vec2::UnitY(), SymbolKinds::kByFacing, sensed);
  mark({wall.reversed(), 3, 0, 0}, Vec2::UnitY(), SymbolKinds::kByFacing, learned);
  SignatureCorrelator correlator(SignatureParams{});
  correlator.correlate(sensed, learned);
  EXPECT_FALSE(correlator.peak_m().has_value());
}

TEST(Signature, NothingInReachHasNoPeak) {
  SignatureCorrelator correlator(SignatureParams{});
  correlator.correlate(Signature{{0, 0, 1}}, Signature{{0, 5, 1}});
  EXPECT_FALSE(correlator.peak_m().has_value());
}

}  // namespace
}  // namespace aisle
