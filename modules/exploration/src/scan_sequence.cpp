#include "scan_sequence.hpp"

namespace aisle {
namespace {

constexpr Side turned_left(Side heading) {
  constexpr Side kLeftOf[] = {Side::kBottom, Side::kTop, Side::kRight, Side::kLeft};
  return kLeftOf[static_cast<unsigned>(heading)];
}

}  // namespace

std::array<Side, 4> scan_sequence(GridRuleSet set, std::optional<Side> came_from) {
  if (set != GridRuleSet::kHoming && set != GridRuleSet::kRoaming)
    return {Side::kLeft, Side::kRight, Side::kTop, Side::kBottom};
  const Side heading = came_from ? opposite(*came_from) : Side::kTop;
  const Side left = turned_left(heading);
  return {left, heading, opposite(left), opposite(heading)};
}

}  // namespace aisle
