#include "aisle/maps/view_pattern.hpp"

#include <utility>

#include "aisle/core/angle.hpp"

namespace aisle {

std::vector<ViewLane> view_pattern() {
  constexpr double kApart_m = 0.1, kTurned_rad = 5 * kDegree;
  constexpr int kFirst = -6, kLast = 2, kWithSides = 3, kLateral = 2;
  std::vector<ViewLane> lanes;
  for (const double turned : {0.0, 1.0, -1.0}) {
    for (int lateral = kLateral; lateral >= -kLateral; --lateral) {
      ViewLane lane{.turned_rad = turned * kTurned_rad, .lateral_m = lateral * kApart_m, .along_m = {}};
      for (int along = kFirst; along <= kLast; ++along)
        if (lateral == 0 || along % kWithSides == 0) lane.along_m.push_back(along * kApart_m);
      lanes.push_back(std::move(lane));
    }
  }
  return lanes;
}

}  // namespace aisle
