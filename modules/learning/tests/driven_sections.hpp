#pragma once

#include "aisle/core/angle.hpp"
#include "aisle/maps/section.hpp"

namespace aisle {

inline Section straight(double length_m, std::optional<double> right_m = {}) {
  return {.kind = Section::Kind::kFollow, .length_m = length_m, .right_m = right_m};
}

inline Section turn(double turn_deg) {
  return {.kind = Section::Kind::kTurn, .turn_rad = turn_deg * kDegree};
}

}  // namespace aisle
