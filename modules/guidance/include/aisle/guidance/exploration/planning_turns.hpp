#pragma once

namespace aisle {

/// Spreads an explorer's planning over cycles: floor is learned in one, the next looks around for frontiers,
/// the one after chooses a target. All other cycles search for a path; at least the one after a choice does.
class PlanningTurns {
 public:
  enum class Turn { kLookAround, kChoose, kSearch };

  /// Once a cycle.
  /// @param is_news     floor was learned in this cycle
  /// @param has_target  without one it looks around even if nothing was learned
  Turn next(bool is_news, bool has_target);

  /// The floor was built again: a target is not chosen by what was seen on the former one.
  void forget_look() {
    if (last_ == Turn::kLookAround) last_ = Turn::kSearch;
  }

 private:
  Turn last_ = Turn::kSearch;
  bool is_look_due_ = false;  ///< floor was learned since the last look around
};

}  // namespace aisle
