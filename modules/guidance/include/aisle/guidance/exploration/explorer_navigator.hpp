#pragma once
/// Explores an unknown building and comes home: C99 Algorithm 1.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "aisle/exploration/building_explorer.hpp"
#include "aisle/guidance/exploration/block_memory.hpp"
#include "aisle/guidance/exploration/bumper_contacts.hpp"
#include "aisle/guidance/exploration/exploring_phase.hpp"
#include "aisle/guidance/exploration/floor_learner.hpp"
#include "aisle/guidance/exploration/learning_progress.hpp"
#include "aisle/guidance/exploration/mission_timer.hpp"
#include "aisle/guidance/exploration/planning_turns.hpp"
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

  /// After it has given up it answers the same for ever.
  Decision step(const Observation& observation) override;

  const FloorLearner& learner() const { return learner_; }
  const BuildingExplorer& explorer() const { return explorer_; }
  const Path& path() const { return driver_.path(); }
  /// The exploration so far.
  ExplorationRecord record() const;

 private:
  /// Whether a search is to begin.
  enum class SearchDue { kNo, kNow, kOnceItStands };
  /// Where the path ends that the vehicle follows, or has followed last.
  enum class PathEnd { kElsewhere, kStage, kHome };

  FloorLearner::News sense(const Observation& observation);
  void become(ExploringEvent event) { phase_ = phase_after(phase_, event); }
  bool has_looked_around();
  Decision wait_for_floor();
  Decision end(NavigatorStatus status, std::string state, std::string why);
  std::string what_was_explored() const;

  // bumper contacts
  Decision back_off(const Observation& observation);
  void note_contact();
  void be_blocked(std::optional<LegDirection> direction);

  // where to go
  void plan(FloorLearner::News news);
  void begin_on_new_floor();
  void check_path();
  void look_around();
  void choose();
  void note_learning(const ExploringTarget& target);
  void leave_what_costs_too_much();
  void check_retry_budget();
  void leave_path();
  void give_up_mission(const std::string& why);

  // how to get there
  void search_path();
  void search_on();
  void want_search();
  bool is_time_to_search() const;
  void begin_search();
  void search_again();
  void advance_search();
  bool may_end_at_home(const Pose2& T_map_from) const;
  Path trail_in() const;
  bool is_roomy(const Pose2& T_map) const;
  void keep_off_what_blocks();
  bool was_worth_it() const;
  void take_path();
  void take_probe(const Path& found);
  void find_no_path();
  bool may_probe() const;
  bool is_shut_in() const;
  bool is_target_shut_off() const;
  void count_failure();
  bool retreat();

  // on the path
  void keep_trail(FloorLearner::News news);
  void mark_coverage();
  Decision drive(const Observation& observation);
  void arrive();
  void shorten_path(double ahead_m);
  void drop_path();
  std::string state_word() const;
  std::string why_it_stands() const;

  ExplorerNavigatorParams params_;
  VehicleDescription vehicle_;
  FloorLearner learner_;
  BuildingExplorer explorer_;
  StagedSearch search_;
  TargetSearch target_search_;
  PathDriver driver_;
  Trail trail_;
  BlockMemory blocks_;
  BumperContacts contacts_;
  PlanningTurns turns_;
  MissionTimer timer_;
  LearningProgress learning_;
  RetryBudget retry_budget_;

  ExploringPhase phase_ = ExploringPhase::kLooking;
  std::optional<ExploringTarget> target_;
  std::optional<ExploringTarget> former_;  ///< the last target, kept after its path was dropped
  TargetTries tries_;                      ///< for the present target
  bool is_out_of_reach_ = false;  ///< no pose shows the target, unless with relaxed clearance: all were tried
  SearchDue search_due_ = SearchDue::kNo;
  Vec2 p_map_searched_ = Vec2::Zero();  ///< the frontier of the last search
  double searched_m2_ = 0;              ///< free floor when that search began
  bool is_where_put_ = true;            ///< the vehicle has not left where it was put
  bool is_wedged_ = false;              ///< that search found no path away from where the vehicle stands
  PathEnd path_end_ = PathEnd::kElsewhere;
  int last_retreats_ = 0;  ///< retreats made as a last resort
  std::size_t cycle_ = 0;
  std::size_t arrived_cycle_ = 0;
  std::vector<CoverageMark> coverage_;
  Decision ended_;  ///< once it is over: what it answered
};

}  // namespace aisle
