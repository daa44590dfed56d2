#include "wall_fates.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr double kStep_m = 0.1;  // along a wall

WallChange change_by(MapOpinion opinion, WallChange if_denied) {
  switch (opinion) {
    case MapOpinion::kConfirmed:
      return WallChange::kKept;
    case MapOpinion::kDenied:
      return if_denied;
    case MapOpinion::kSilent:
      break;
  }
  return WallChange::kNotCompared;
}

}  // namespace

std::size_t fate_steps(const Wall& wall) {
  return static_cast<std::size_t>(std::max(1L, std::lround(wall.segment.length() / kStep_m)));
}

Vec2 middle_of_step(const Segment2& segment, std::size_t step, std::size_t steps) {
  return segment.start +
         (segment.end - segment.start) * ((static_cast<double>(step) + 0.5) / static_cast<double>(steps));
}

void smooth_fates(std::vector<WallChange>& fates) {
  const auto least = std::lround(kFateMin_m / kStep_m);
  const auto has_changed = [](WallChange fate) {
    return fate == WallChange::kNew || fate == WallChange::kGone;
  };
  for (auto run = fates.begin(); run != fates.end();) {
    const auto end = std::find_if(run, fates.end(), [&](WallChange fate) { return fate != *run; });
    const bool has_before = run != fates.begin(), has_behind = end != fates.end();
    if (end - run < least && (has_before || has_behind)) {
      const bool follows =
          has_behind && (!has_before || (*run == WallChange::kNotCompared && has_changed(*end)));
      std::fill(run, end, follows ? *end : *(run - 1));
    }
    run = end;
  }
}

std::vector<WallChange> fates_along(const Wall& wall, const MapPattern& other, WallChange if_denied,
                                    double beyond_m) {
  const Vec2 normal = left_normal((wall.segment.end - wall.segment.start).normalized());
  const std::size_t steps = fate_steps(wall);
  std::vector<WallChange> fates;
  fates.reserve(steps);
  for (std::size_t i = 0; i < steps; ++i)
    fates.push_back(
        change_by(other.opinion_of(middle_of_step(wall.segment, i, steps), normal, beyond_m), if_denied));
  smooth_fates(fates);
  return fates;
}

}  // namespace aisle
