#include "aisle/matching/signature.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace aisle {
namespace {

constexpr double kAcross =
    0.98;  // |cos| of the angle between a segment's normal and the axis: within 11 degrees
constexpr double kAlong = 0.5;  // |cos| between the segment and the axis: its ends are well placed on it

/// Step 4's weights 1 / (1 + |i| / d), correlated with themselves: what one pair of symbols adds to C.
std::vector<double> autocorrelation(int neighbourhood, double tolerance) {
  const int half = neighbourhood / 2;
  const auto weight = [&](int i) { return 1 / (1 + std::abs(i) / tolerance); };
  std::vector<double> kernel(4 * static_cast<std::size_t>(half) + 1, 0.0);
  for (int a = -half; a <= half; ++a) {
    for (int b = -half; b <= half; ++b)
      kernel[static_cast<std::size_t>(b - a + 2 * half)] += weight(a) * weight(b);
  }
  return kernel;
}

bool before(const SignatureSymbol& a, const SignatureSymbol& b) {
  return a.kind != b.kind ? a.kind < b.kind : a.position_m < b.position_m;
}

}  // namespace

void mark(const MarkedSegment& marked, const Vec2& axis, SymbolKinds kinds, Signature& signature) {
  const Segment2& s = marked.segment;
  const Vec2 along = (s.end - s.start).normalized();
  const double along_axis = along.dot(axis), across_axis = left_normal(along).dot(axis);
  const auto kind = [&](int role, bool forward) {
    return kinds == SymbolKinds::kOne ? 0 : 2 * role + (forward ? 0 : 1);
  };
  if (std::abs(across_axis) > kAcross) {
    signature.push_back({kind(0, across_axis > 0), axis.dot(s.midpoint()), marked.length_weight});
  } else if (std::abs(along_axis) > kAlong) {
    if (marked.start_weight > 0)
      signature.push_back({kind(1, along_axis > 0), axis.dot(s.start), marked.start_weight});
    if (marked.end_weight > 0)
      signature.push_back({kind(2, along_axis > 0), axis.dot(s.end), marked.end_weight});
  }
}

void sort_symbols(Signature& signature) {
  std::sort(signature.begin(), signature.end(), before);
}

SignatureCorrelator::SignatureCorrelator(const SignatureParams& params)
    : params_(params),
      half_cells_(static_cast<int>(std::ceil(params.reach_m / params.cell_m))),
      kernel_(autocorrelation(params.neighbourhood, params.tolerance)),
      values_(2 * static_cast<std::size_t>(half_cells_) + 1, 0.0) {}

double SignatureCorrelator::displacement_m(std::size_t index) const {
  return (static_cast<int>(index) - half_cells_) * params_.cell_m;
}

std::span<double> SignatureCorrelator::correlate(std::span<const SignatureSymbol> sensed,
                                                 std::span<const SignatureSymbol> learned) {
  std::fill(values_.begin(), values_.end(), 0.0);
  const int half_kernel = static_cast<int>(kernel_.size() / 2);
  const double reach_m = params_.reach_m + (half_kernel + 0.5) * params_.cell_m;
  for (const SignatureSymbol& s : sensed) {
    auto l = std::lower_bound(learned.begin(), learned.end(),
                              SignatureSymbol{s.kind, s.position_m - reach_m, 0}, before);
    for (; l != learned.end() && l->kind == s.kind && l->position_m <= s.position_m + reach_m; ++l) {
      const int centre =
          static_cast<int>(std::lround((l->position_m - s.position_m) / params_.cell_m)) + half_cells_;
      const double weight = s.weight * l->weight;
      const int first = std::max(-half_kernel, -centre);
      const int last = std::min(half_kernel, static_cast<int>(values_.size()) - 1 - centre);
      for (int i = first; i <= last; ++i) {
        values_[static_cast<std::size_t>(centre + i)] +=
            weight * kernel_[static_cast<std::size_t>(i + half_kernel)];
      }
    }
  }
  return values_;
}

std::optional<std::size_t> SignatureCorrelator::highest() const {
  std::optional<std::size_t> best;
  double best_value = 0;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const bool nearer =
        best && values_[i] == best_value &&
        std::abs(static_cast<int>(i) - half_cells_) < std::abs(static_cast<int>(*best) - half_cells_);
    if (values_[i] > best_value || nearer) {
      best = i;
      best_value = values_[i];
    }
  }
  return best;
}

double SignatureCorrelator::refined_m(std::size_t index) const {
  double part = 0;
  if (index > 0 && index + 1 < values_.size()) {
    const double left = values_[index - 1], right = values_[index + 1];
    const double curvature = left - 2 * values_[index] + right;
    if (curvature < 0) part = std::clamp(0.5 * (left - right) / curvature, -0.5, 0.5);
  }
  return displacement_m(index) + part * params_.cell_m;
}

std::optional<double> SignatureCorrelator::peak_m() const {
  const auto index = highest();
  return index ? std::optional(refined_m(*index)) : std::nullopt;
}

void SignatureCorrelator::peaks_m(int count, double apart_m, std::vector<double>& peaks) {
  const auto apart = static_cast<std::size_t>(std::lround(apart_m / params_.cell_m));
  for (int k = 0; k < count; ++k) {
    const auto index = highest();
    if (!index) return;
    peaks.push_back(refined_m(*index));
    const std::size_t first = *index > apart ? *index - apart : 0;
    const std::size_t last = std::min(*index + apart, values_.size() - 1);
    std::fill(values_.begin() + static_cast<std::ptrdiff_t>(first),
              values_.begin() + static_cast<std::ptrdiff_t>(last) + 1, 0.0);
  }
}

}  // namespace aisle
