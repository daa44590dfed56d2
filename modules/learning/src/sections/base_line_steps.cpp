#include "sections/base_line_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "aisle/core/median.hpp"
#include "aisle/learning/sections/walls_beside.hpp"

namespace aisle {
namespace {

constexpr double kSpan_m = 0.5;  // length of a span of the segment, with one distance
constexpr std::size_t kSpansMost = 200;
constexpr std::size_t kPartMin = 6;  // spans between two steps
constexpr double kStepMin_m = 0.08;  // smaller steps are ignored
constexpr double kOff_m = 0.25;      // larger deviations count as this
constexpr double kPrice_m = 1;       // cost of a step: it must lower the sum of deviations by this
constexpr double kLookedAt_m = 4;    // ahead of the vehicle; farther walls are seen inaccurately
constexpr double kNearestSeen_m = 0.12, kFarthest_m = 3;

/// The distances of the base line on one side, span by span; nullopt: not seen.
using SideProfile = std::vector<std::optional<double>>;

class PathSegmentProfile {
 public:
  explicit PathSegmentProfile(double length_m)
      : spans_(std::clamp<std::size_t>(static_cast<std::size_t>(length_m / kSpan_m), 1, kSpansMost)),
        span_m_(length_m / static_cast<double>(spans_)),
        seen_m_{Seen(spans_), Seen(spans_)} {}

  std::size_t spans() const { return spans_; }
  double along_m(std::size_t span) const { return span_m_ * static_cast<double>(span); }

  void add(const PathSegmentView& view) {
    find_walls_beside(view.edges, view.T_path_segment_vehicle, beside_);
    const double here_m = view.T_path_segment_vehicle.x;
    const auto first =
        static_cast<std::size_t>(std::clamp(here_m / span_m_, 0.0, static_cast<double>(spans_)));
    for (std::size_t span = first; span < spans_ && along_m(span) < here_m + kLookedAt_m; ++span) {
      for (const bool is_left : {false, true})
        if (const auto distance_m = nearest_m(span, is_left))
          seen_m_[is_left ? 1 : 0][span].push_back(*distance_m);
    }
  }

  SideProfile side(bool is_left) const {
    SideProfile profile;
    for (const std::vector<double>& seen_m : seen_m_[is_left ? 1 : 0])
      profile.push_back(seen_m.empty() ? std::nullopt : std::optional(median(seen_m)));
    return profile;
  }

 private:
  using Seen = std::vector<std::vector<double>>;

  /// The nearest wall that is seen beside all of a span.
  std::optional<double> nearest_m(std::size_t span, bool is_left) const {
    std::optional<double> nearest;
    for (const WallBeside& wall : beside_) {
      const double distance_m = is_left ? wall.lateral_m : -wall.lateral_m;
      if (distance_m < kNearestSeen_m || distance_m > kFarthest_m) continue;
      if (wall.from_m > along_m(span) || wall.to_m < along_m(span + 1)) continue;
      if (!nearest || distance_m < *nearest) nearest = distance_m;
    }
    return nearest;
  }

  std::size_t spans_;
  double span_m_;
  Seen seen_m_[2];
  std::vector<WallBeside> beside_;
};

std::optional<double> usual_m(const SideProfile& profile, std::size_t first, std::size_t end) {
  std::vector<double> seen_m;
  for (std::size_t span = first; span < end; ++span)
    if (profile[span]) seen_m.push_back(*profile[span]);
  if (2 * seen_m.size() < end - first) return std::nullopt;
  return median(std::move(seen_m));
}

/// Sum of the deviations of some spans' distances from their median.
double sum_off_m(const SideProfile& profile, std::size_t first, std::size_t end) {
  const auto usual = usual_m(profile, first, end);
  double sum_m = 0;
  for (std::size_t span = first; span < end; ++span)
    if (profile[span]) sum_m += usual ? std::min(kOff_m, std::abs(*profile[span] - *usual)) : kOff_m;
  return sum_m;
}

/// The best way to divide the spans: the one with the least sum of deviations and step costs.
/// @return the first span of each part except the first
std::vector<std::size_t> best_parting(const SideProfile& right, const SideProfile& left) {
  const std::size_t spans = right.size();
  std::vector<double> least_m(spans + 1, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> from(spans + 1, 0);
  least_m[0] = 0;
  for (std::size_t end = kPartMin; end <= spans; ++end) {
    for (std::size_t first = 0; first + kPartMin <= end; ++first) {
      const double sum_m =
          least_m[first] + kPrice_m + sum_off_m(right, first, end) + sum_off_m(left, first, end);
      if (sum_m >= least_m[end]) continue;
      least_m[end] = sum_m;
      from[end] = first;
    }
  }
  std::vector<std::size_t> parts;
  for (std::size_t end = spans; from[end] > 0; end = from[end]) parts.push_back(from[end]);
  std::reverse(parts.begin(), parts.end());
  return parts;
}

bool steps_sideways(const SideProfile& profile, std::size_t first, std::size_t step, std::size_t end) {
  const auto before_m = usual_m(profile, first, step), after_m = usual_m(profile, step, end);
  return before_m && after_m && std::abs(*after_m - *before_m) >= kStepMin_m;
}

}  // namespace

std::vector<double> base_line_steps_m(double length_m, std::span<const PathSegmentView> views) {
  PathSegmentProfile profile(length_m);
  for (const PathSegmentView& view : views) profile.add(view);
  const SideProfile right = profile.side(false), left = profile.side(true);
  std::vector<std::size_t> bounds = best_parting(right, left);
  bounds.push_back(profile.spans());
  std::vector<double> steps_m;
  std::size_t first = 0;
  for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
    const std::size_t step = bounds[i], end = bounds[i + 1];
    if (!steps_sideways(right, first, step, end) && !steps_sideways(left, first, step, end)) continue;
    steps_m.push_back(profile.along_m(step));
    first = step;
  }
  return steps_m;
}

}  // namespace aisle
