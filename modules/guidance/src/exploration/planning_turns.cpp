#include "aisle/guidance/exploration/planning_turns.hpp"

namespace aisle {

PlanningTurns::Turn PlanningTurns::next(bool is_news, bool has_target) {
  switch (last_) {
    case Turn::kLookAround:
      last_ = Turn::kChoose;
      break;
    case Turn::kChoose:
      last_ = Turn::kSearch;
      break;
    case Turn::kSearch:
      if (is_look_due_ || (!has_target && !is_news)) {
        is_look_due_ = false;
        last_ = Turn::kLookAround;
      }
      break;
  }
  is_look_due_ = is_look_due_ || is_news;
  return last_;
}

}  // namespace aisle
