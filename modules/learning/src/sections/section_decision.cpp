#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/learning/sections/section_learning.hpp"

namespace aisle {
namespace {

constexpr double kQuarter_rad = kPi / 2;

bool is_turn(const SectionList& list, std::size_t i) {
  return i < list.size() && list[i].kind == Section::Kind::kTurn;
}

bool is_left_turn(const SectionList& list, std::size_t i) {
  return is_turn(list, i) && list[i].turn_rad > 0;
}

bool is_straight_ahead(const SectionList& list, std::size_t i) {
  return i < list.size() && list[i].kind == Section::Kind::kFollow;
}

/// Section 3.2 A: a left turn, straight on, and a left turn that sum to a quarter turn.
bool is_corner(const SectionList& list, std::size_t i, const SectionLearningParams& params) {
  return is_left_turn(list, i) && is_straight_ahead(list, i + 1) && is_left_turn(list, i + 2) &&
         list[i + 1].length_m <= params.corner_max_m &&
         std::abs(list[i].turn_rad + list[i + 2].turn_rad - kQuarter_rad) < params.corner_rad;
}

/// Section 3.2 B: between two quarter turns to the same side, as long as the corridor's width less the
/// distances kept before and after.
bool is_crossing(const SectionList& list, std::size_t i, std::optional<double> corridor_width_m,
                 const SectionLearningParams& params) {
  if (i < 2 || i + 2 >= list.size() || !corridor_width_m) return false;
  if (!is_turn(list, i - 1) || !is_turn(list, i + 1)) return false;
  const double before_rad = list[i - 1].turn_rad, after_rad = list[i + 1].turn_rad;
  if (before_rad * after_rad < 0 || std::abs(std::abs(before_rad) - kQuarter_rad) >= params.crossing_rad ||
      std::abs(std::abs(after_rad) - kQuarter_rad) >= params.crossing_rad)
    return false;
  const bool is_left = before_rad > 0;
  const auto kept_before = is_left ? list[i - 2].right_m : list[i - 2].left_m;
  const auto kept_after = is_left ? list[i + 2].right_m : list[i + 2].left_m;
  return kept_before && kept_after &&
         std::abs(*kept_before + *kept_after + list[i].length_m - *corridor_width_m) < params.crossing_m;
}

/// P2 as seen from P1: the chord, turned by the first of the two turns.
Section corner(const Section& first, const Section& chord) {
  return {.kind = Section::Kind::kCurve, .p_start_end = chord.length_m * unit(first.turn_rad)};
}

}  // namespace

SectionList decide_sections(const SectionList& driven, std::optional<double> corridor_width_m,
                            const SectionLearningParams& params) {
  SectionList decided;
  for (std::size_t i = 0; i < driven.size(); ++i) {
    if (is_corner(driven, i, params)) {
      decided.push_back(corner(driven[i], driven[i + 1]));
      i += 2;
      continue;
    }
    decided.push_back(driven[i]);
    if (!is_straight_ahead(driven, i)) continue;
    if (is_crossing(driven, i, corridor_width_m, params)) {
      decided.back().kind = Section::Kind::kDead;
    } else if (is_turn(driven, i + 1) && driven[i + 1].turn_rad < 0) {
      decided.back().kind = Section::Kind::kHybrid;
    }
  }
  return decided;
}

}  // namespace aisle
