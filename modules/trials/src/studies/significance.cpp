#include "studies/significance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "aisle/core/random.hpp"

namespace aisle {
namespace {

constexpr double kNormalQuantile = 1.959964;  // of 0.975
constexpr std::size_t kExactMax = 14;         // differences
constexpr std::size_t kFlips = 20'000;
constexpr std::size_t kResamples = 4'000;

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// The sum with the signs turned that `flips` has a bit for.
double flipped_sum(const std::vector<double>& differences, std::uint64_t flips) {
  double sum = 0;
  for (std::size_t i = 0; i < differences.size(); ++i)
    sum += ((flips >> i) & 1U) != 0 ? -differences[i] : differences[i];
  return sum;
}

double randomly_flipped_sum(const std::vector<double>& differences, Random& random) {
  double sum = 0;
  for (const double difference : differences) sum += (random.bits() >> 63U) != 0 ? -difference : difference;
  return sum;
}

}  // namespace

Confidence wilson_interval(std::size_t successes, std::size_t trials) {
  if (trials == 0) return {0, 1};
  const auto n = static_cast<double>(trials);
  const double share = static_cast<double>(successes) / n;
  const double z2 = kNormalQuantile * kNormalQuantile;
  const double centre = share + z2 / (2 * n);
  const double half = kNormalQuantile * std::sqrt(share * (1 - share) / n + z2 / (4 * n * n));
  return {std::max(0.0, (centre - half) / (1 + z2 / n)), std::min(1.0, (centre + half) / (1 + z2 / n))};
}

double mcnemar_p(std::size_t only_first, std::size_t only_second) {
  const std::size_t fewer = std::min(only_first, only_second), all = only_first + only_second;
  const auto n = static_cast<double>(all);
  double tail = 0;  // chance of at most `fewer` of `all`, each with 1/2
  for (std::size_t k = 0; k <= fewer; ++k) {
    const auto chosen = static_cast<double>(k);
    tail += std::exp(std::lgamma(n + 1) - std::lgamma(chosen + 1) - std::lgamma(n - chosen + 1) -
                     n * std::log(2.0));
  }
  return std::min(1.0, 2 * tail);
}

double sign_flip_p(const std::vector<double>& differences) {
  const double observed =
      std::abs(sum_of(differences)) * (1 - 1e-12);  // the unflipped counts in spite of rounding
  const std::size_t count = differences.size();
  if (count <= kExactMax) {
    const std::uint64_t patterns = std::uint64_t{1} << count;
    std::size_t as_far = 0;
    for (std::uint64_t flips = 0; flips < patterns; ++flips)
      as_far += std::abs(flipped_sum(differences, flips)) >= observed ? 1 : 0;
    return static_cast<double>(as_far) / static_cast<double>(patterns);
  }
  Random random(1);
  std::size_t as_far = 1;  // the observed one
  for (std::size_t i = 0; i < kFlips; ++i)
    as_far += std::abs(randomly_flipped_sum(differences, random)) >= observed ? 1 : 0;
  return static_cast<double>(as_far) / static_cast<double>(kFlips + 1);
}

Confidence bootstrap_interval(const std::vector<double>& values) {
  if (values.empty()) return {};
  Random random(1);
  std::vector<double> means(kResamples);
  for (double& mean : means) {
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) sum += values[random.index(values.size())];
    mean = sum / static_cast<double>(values.size());
  }
  std::sort(means.begin(), means.end());
  return {means[kResamples / 40], means[kResamples - 1 - kResamples / 40]};
}

std::vector<double> holm_adjusted(const std::vector<double>& p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::vector<double> adjusted(p.size());
  double least = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    least = std::max(least, std::min(1.0, static_cast<double>(order.size() - i) * p[order[i]]));
    adjusted[order[i]] = least;
  }
  return adjusted;
}

}  // namespace aisle
