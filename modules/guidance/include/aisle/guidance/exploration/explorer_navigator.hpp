#pragma once
/// Explores an unknown building and comes home: C99 Algorithm 1.

#include <memory>
#include <optional>
#include <string>

#include "aisle/exploration/building_explorer.hpp"
#include "aisle/guidance/exploration/block_memory.hpp"
#include "aisle/guidance/exploration/floor_learner.hpp"
#include "aisle/guidance/exploration/retry_budget.hpp"
#include "aisle/guidance/exploration/target_search.hpp"
#include "aisle/guidance/exploration/trail.hpp"
#include "aisle/guidance/navigator.hpp"
#include "aisle/guidance/paths/path_driver.hpp"

namespace aisle {

struct ExplorerNavigatorParams {
  FloorLearnerParams learner;
  ExplorerParams explorer;
  CarSearchParams search;
  SteeringParams steering;
  SpeedParams speed{.speed_mps = 0.4};
  double look_s = 1;         ///< it stands and looks around before it starts
  double look_from_m = 2.5;  ///< distance from which it looks at a target
  double join_m = 0.6;       ///< a new path joins the old one this far ahead
  RetryBudgetParams retry_budget;
  double time_max_s = 14400;  ///< then it gives up, wherever it is
  int expansions = 2000;      ///< of the path search, per cycle
  double stuck_s = 120;       ///< it gives up after standing without a path for this long

  void describe(FieldList& fields);
};

/// Maps the floor and localises on it, finds frontiers, and lets C99's transducer choose one. Then plans a
/// path over known free floor to a pose that sees the frontier, and drives it. Drives home when no frontier
/// is left.
class ExplorerNavigator final : public Navigator {
 public:
  ExplorerNavigator(const ExplorerNavigatorParams& params, const VehicleDescription& vehicle,
                    ExploringOrder order, std::unique_ptr<ScanSource> sensor);

  Decision step(const Observation& observation) override;

  const FloorLearner& learner() const { return learner_; }
  const BuildingExplorer& explorer() const { return explorer_; }
  const Path& path() const { return driver_.path(); }
  /// The exploration so far.
  ExplorationRecord record() const;

 private:
  bool has_new_contact(const Observation& observation);
  Decision back_off(const Observation& observation);
  void note_contact();
  void keep_trail(FloorLearner::News news);
  void mark_coverage();
  void think(FloorLearner::News news);
  void look_around();
  void choose();
  void begin_search();
  bool may_end_at_home(const Pose2& T_map_from) const;
  void keep_off_what_blocks();
  void search_on();
  void search_path();
  bool was_worth_it() const;
  void find_no_path();
  bool is_shut_in() const;
  bool is_target_shut_off() const;
  bool retreat();
  void give_up_mission(const std::string& why);
  void count_failure();
  void leave_path();
  void give_path_up();
  void note_learning(const ExploringTarget& target);
  void check_retry_budget();
  Decision wait_for_floor();
  void begin_on_new_floor();
  void take_path();
  void arrive();
  void shorten_path(double ahead_m);
  void drop_path();
  void check_path();
  bool is_stuck();
  std::string what_was_explored() const;
  Decision drive(const Observation& observation);
  void be_blocked(std::optional<Gear> gear);
  std::string state_word() const;
  std::string why_it_stands() const;
  Decision end(NavigatorStatus status, std::string state, std::string why);

  ExplorerNavigatorParams params_;
  VehicleDescription vehicle_;
  FloorLearner learner_;
  BuildingExplorer explorer_;
  StagedSearch search_;
  TargetSearch target_search_;
  PathDriver driver_;
  RetryBudget retry_budget_;
  Trail trail_;
  bool is_look_due_ = false;        ///< floor was learned since the last look around
  bool is_choice_due_ = false;      ///< the last look around is done, the next target is to be chosen
  bool is_turn_of_search_ = false;  ///< the target was chosen in the last cycle
  std::optional<ExploringTarget> target_;
  std::optional<ExploringTarget> former_;  ///< the last target, kept after its path was dropped
  BlockMemory blocks_;
  std::optional<Gear> driven_gear_;  ///< in the last cycle that drove
  bool is_in_contact_ = false;
  bool is_contact_due_ = false;  ///< a bumper contact is to be noted as soon as the vehicle stands
  int contacts_ = 0;
  Vec2 p_map_searched_ = Vec2::Zero();  ///< the frontier of the last search
  double searched_m2_ = 0;              ///< free floor when that search began
  bool is_search_due_ = false;
  bool is_stage_ = false;      ///< the path ends before its target
  bool stands_first_ = false;  ///< the search that is due begins where the vehicle stops
  bool ends_at_home_ = false;  ///< the path does
  bool is_out_of_reach_ =
      false;           ///< all poses were tried: none shows the target, unless it relaxes its clearance
  TargetTries tries_;  ///< for the present target
  bool is_retreating_ = false;  ///< it drives back along its trail
  int last_retreats_ = 0;       ///< retreats made as a last resort
  bool is_wedged_ = false;      ///< no path leads away from where the vehicle stands
  std::size_t arrived_cycle_ = 0;
  std::size_t cycle_ = 0;
  std::optional<double> begun_s_;
  double stamp_s_ = 0;
  double moved_s_ = 0;
  double learned_m2_ = 0;      ///< free floor when new floor last renewed the retry budget
  double learned_path_m_ = 0;  ///< distance travelled until then
  std::vector<CoverageMark> coverage_;
  std::string ended_because_;
  bool came_home_ = false;
};

}  // namespace aisle
