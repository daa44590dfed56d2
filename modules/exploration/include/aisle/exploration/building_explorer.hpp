#pragma once
/// C99's environment exploration in a real building: preprocessing unit, navigation transducer, and the order
/// in which waiting paths are taken. It decides where to go and drives nothing itself.

#include <optional>
#include <string_view>
#include <vector>

#include "aisle/exploration/corridor_rules.hpp"
#include "aisle/exploration/exploration_record.hpp"
#include "aisle/exploration/pockets.hpp"

namespace aisle {

enum class ExploringOrder {
  kPublished,    ///< C99: last in, first out; returns from crossing to crossing
  kRecommended,  ///< first what the current path leads to, then what is near or far from home
  kNearest,      ///< the baseline: always the nearest frontier
};

inline constexpr ExploringOrder kExploringOrders[] = {ExploringOrder::kPublished,
                                                      ExploringOrder::kRecommended, ExploringOrder::kNearest};

std::string_view name_of(ExploringOrder order);
std::optional<ExploringOrder> exploring_order(std::string_view name);

struct ExplorerParams {
  FrontierParams frontiers;
  PocketParams pockets;
  double home_weight = 0.8;      ///< how strongly paths far from home are preferred
  double leftover_m2 = 1;        ///< a frontier with less floor behind it is a leftover ...
  double leftover_bonus_m = 4;   ///< ... and goes before frontiers up to this much nearer
  double same_frontier_m = 0.3;  ///< a frontier within this of an old one continues it
  double crossing_near_m = 0.5;  ///< published order: within this of a crossing the vehicle is back at it

  void describe(FieldList& fields);
};

/// Where to go next.
struct ExploringTarget {
  enum class Kind {
    kPath,      ///< look behind `frontier`
    kCrossing,  ///< back to `T_map_back`
    kHome,      ///< everything is explored
  };
  Kind kind = Kind::kHome;
  std::size_t path = 0;
  Frontier frontier;
  Pose2 T_map_back;
};

class BuildingExplorer {
 public:
  BuildingExplorer(const ExplorerParams& params, ExploringOrder order);

  /// C99's step 9: encodes which paths lead on, by what is known now.
  void look_around(const KnownFloor& floor, const Vec2& p_map_middle);
  /// C99's step 10: where to go next. Call it after look_around() on the same floor, of which a little more
  /// may be known by now.
  /// @param T_map_home  where the exploration began
  ExploringTarget decide(const KnownFloor& floor, const Pose2& T_map_vehicle, const Pose2& T_map_home,
                         std::size_t cycle);

  /// The vehicle cannot get back to the crossing and goes on from where it is.
  void pass_crossing_by();
  /// The vehicle cannot look behind this path's frontier, which counts as seen from outside.
  void give_up(std::size_t path, std::size_t cycle);
  /// The time for this path has run out; it stays unexplored.
  void abandon(std::size_t path, std::size_t cycle);
  /// Abandons all waiting paths except far pockets, which were not worth a detour anyway.
  void abandon_all(std::size_t cycle);
  /// Whether more than leftovers may lie behind a path that was given up or abandoned.
  bool has_left_floor() const;
  /// From now on the floor's cells are half as wide; paths given up or abandoned are tried again.
  void halve_cells();
  /// The vehicle is home and everything is explored.
  void stop(std::size_t cycle);

  const TransducerRun& transducer() const { return run_; }
  const std::vector<PathEvent>& events() const { return events_; }
  const std::vector<TransducerStep>& steps() const { return steps_; }
  /// Frontiers of the latest decision.
  const std::vector<Frontier>& frontiers() const { return frontiers_; }
  std::size_t paths_waiting() const;
  std::size_t paths_abandoned() const;

 private:
  enum class PathState { kWaiting, kActive, kExplored, kGivenUp, kAbandoned };
  struct SeenPath {
    std::size_t parent = 0;
    Bearing bearing = Bearing::kForward;
    PathState state = PathState::kWaiting;
    bool on_stack = false;
    bool has_frontier = true;
    int chances = 1;                 ///< retries left after it was given up or abandoned ...
    Vec2 p_map_left = Vec2::Zero();  ///< ... with the vehicle here ...
    double free_m2_left = 0;         ///< ... and this much free floor known
    Frontier frontier;
  };
  /// What a symbol of the stack stands for.
  struct Waiting {
    std::size_t path = 0;  ///< of an explore symbol
    Pose2 T_map_crossing;  ///< of a return path
  };

  void match_frontiers(const FloorGrid& floor, const Pose2& T_map_vehicle);
  std::optional<std::size_t> continued_by(const FloorGrid& floor, const Frontier& frontier) const;
  std::size_t add_path(Frontier frontier, const Pose2& T_map_vehicle);
  std::optional<ExploringTarget> go_on(const Pose2& T_map_vehicle);
  ExploringTarget take_from_stack(const Pose2& T_map_vehicle);
  std::optional<std::size_t> best_child() const;
  std::optional<std::size_t> best_waiting() const;
  void push_waiting(const Pose2& T_map_vehicle);
  void close_stale_tops();
  ExploringTarget take(std::size_t path);
  const TransducerRule& feed(Symbol input);
  void note(PathEvent::Kind kind, std::size_t path);
  void leave(std::size_t path, PathState state, PathEvent::Kind kind, std::size_t cycle);
  bool resume_left();
  bool leave_far_pockets();
  bool is_left_with_floor(const SeenPath& path) const {
    return is_left(path) && path.has_frontier && path.frontier.behind_m2 >= params_.leftover_m2;
  }
  static bool is_open(const SeenPath& path) {
    return path.state == PathState::kWaiting || path.state == PathState::kActive;
  }
  static bool is_left(const SeenPath& path) {
    return path.state == PathState::kGivenUp || path.state == PathState::kAbandoned;
  }

  ExplorerParams params_;
  ExploringOrder order_;
  TransducerRun run_;
  std::vector<SeenPath> paths_;
  std::vector<Waiting> stack_;  ///< parallel to the transducer's stack, without its start symbol
  std::optional<std::size_t> active_;
  std::optional<Pose2> T_map_going_back_;
  Pose2 T_map_decided_;  ///< where the baseline last chose a target
  Vec2 p_map_vehicle_ = Vec2::Zero();
  double free_m2_ = 0;
  bool is_going_home_ = false;
  std::vector<Frontier> frontiers_;
  std::vector<PathEvent> events_;
  std::vector<TransducerStep> steps_;
  CellMarks marks_;
  FloorDistances from_vehicle_;
  FloorDistances from_home_;
  std::size_t cycle_ = 0;
};

}  // namespace aisle
