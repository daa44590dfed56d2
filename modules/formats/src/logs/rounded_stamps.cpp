#include "logs/rounded_stamps.hpp"

#include <algorithm>
#include <vector>

namespace aisle {
namespace {

constexpr double kLongestRun_s = 60;
constexpr std::size_t kRunsMin = 3;
constexpr std::size_t kRunLengthMin = 3;  // a stamp twice in a row happens to good clocks

/// Where each run of equal stamps begins, and the end.
std::vector<std::size_t> run_starts(std::span<const double> stamps_s) {
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < stamps_s.size(); ++i) {
    if (i == 0 || stamps_s[i] != stamps_s[i - 1]) starts.push_back(i);
  }
  starts.push_back(stamps_s.size());
  return starts;
}

bool is_rounded(std::span<const double> stamps_s, const std::vector<std::size_t>& starts) {
  const std::size_t runs = starts.size() - 1;
  if (runs < kRunsMin || 2 * runs > stamps_s.size()) return false;
  std::size_t longest = 0;
  for (std::size_t run = 0; run < runs; ++run) longest = std::max(longest, starts[run + 1] - starts[run]);
  if (longest < kRunLengthMin) return false;
  for (std::size_t run = 1; run < runs; ++run) {
    const double step_s = stamps_s[starts[run]] - stamps_s[starts[run - 1]];
    if (!(step_s > 0 && step_s <= kLongestRun_s)) return false;
  }
  return true;
}

}  // namespace

std::size_t spread_rounded_stamps(std::span<double> stamps_s) {
  const std::vector<std::size_t> starts = run_starts(stamps_s);
  if (!is_rounded(stamps_s, starts)) return stamps_s.size();
  double step_s = 0;
  for (std::size_t run = 0; run + 1 < starts.size(); ++run) {
    const std::size_t first = starts[run], end = starts[run + 1];
    const double stamp_s = stamps_s[first];
    // The last run may have been cut short: it goes on as the one before.
    if (end < stamps_s.size()) step_s = (stamps_s[end] - stamp_s) / static_cast<double>(end - first);
    for (std::size_t i = first + 1; i < end; ++i) {
      stamps_s[i] = stamp_s + step_s * static_cast<double>(i - first);
    }
  }
  std::size_t changed = 0;
  while (starts[changed + 1] - starts[changed] == 1) ++changed;
  return starts[changed] + 1;
}

}  // namespace aisle
