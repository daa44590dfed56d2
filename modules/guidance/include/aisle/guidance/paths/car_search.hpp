#pragma once
/// Plans paths for a vehicle that cannot move sideways: a lattice search over poses, forwards and backwards,
/// along arcs that it can drive, with its whole footprint kept on known free floor.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "aisle/control/path.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/exploration/floor_distances.hpp"
#include "aisle/guidance/paths/footprint_clearance.hpp"

namespace aisle {

struct CarSearchParams {
  double margin_m = 0.05;            ///< around the footprint
  double steering_share = 0.85;      ///< of the steering range used by paths; the rest is for following them
  double reverse_factor = 1.5;       ///< cost of path driven backwards
  double cusp_m = 0.8;               ///< cost of a change of direction
  double clearance_wanted_m = 0.35;  ///< less clearance than this beyond the margin costs
  double narrow_factor = 2;          ///< cost factor added where there is no such clearance
  double heuristic_weight =
      1.4;                      ///< of the path left: more finds a path sooner, which may be a little longer
  double stage_m = 12;          ///< paths that are much longer are planned in stages of this length
  int expansions_max = 200000;  ///< poses expanded before the search gives up

  void describe(FieldList& fields);
};

/// One search, which runs in portions.
class CarSearch {
 public:
  enum class State { kIdle, kSearching, kFound, kNone };
  using IsGoal = std::function<bool(const Pose2& T_map_vehicle)>;

  CarSearch(const CarSearchParams& params, const VehicleDescription& vehicle);

  /// Searches from the vehicle's pose to any pose that is a goal.
  /// @param left_m  heuristic: lower bound of the path from a point to the goal
  void look_for(const Pose2& T_map_vehicle, IsGoal is_goal, std::function<double(const Vec2&)> left_m);

  /// Searches from about the vehicle's pose to exactly a goal pose. The search runs backwards from the goal,
  /// so that its error is at the start, where the steering corrects it.
  /// @param left_m  heuristic: lower bound of the path from the vehicle to a point
  void look_for_path_to(const Pose2& T_map_goal, const Pose2& T_map_vehicle,
                        std::function<double(const Vec2&)> left_m);

  /// Searches from about the vehicle's pose to any good pose in a box. The search runs backwards from all of
  /// them at once: if they are shut off from the vehicle, it takes few expansions to know that.
  /// @param left_m  heuristic: lower bound of the path from the vehicle to a point
  void look_for_path_to_any(IsGoal is_good, const FloorBox& places, const Pose2& T_map_vehicle,
                            std::function<double(const Vec2&)> left_m);

  /// For the search that was begun: the path must not begin in this direction, because something stands there
  /// that the floor does not show. nullopt: it may begin in any.
  void forbid_first(std::optional<LegDirection> direction) { forbidden_first_ = direction; }

  /// For the search that was begun: only poses that pass this test are used, whatever the floor shows.
  void keep_to(std::function<bool(const Pose2& T_map_vehicle)> is_free) { is_free_ = std::move(is_free); }

  /// For the search that was begun: allows sharper bends, and less clearance than the margin. For use when
  /// there is no path otherwise, as both make the path harder to follow.
  void relax_clearance() { relaxes_clearance_ = true; }

  /// For the search that was begun: within 2 m of where it begins, floor counts as free unless it is known to
  /// be occupied. For a vehicle that has not seen the floor beside and behind it yet.
  void cross_unknown() { crosses_unknown_ = true; }

  /// Goes on for up to `expansions` poses; fewer where one takes longer.
  State advance(const KnownFloor& floor, int expansions);

  /// Ends the search without a path.
  void stop() { state_ = State::kIdle; }

  State state() const { return state_; }
  const FootprintClearance& footprint_clearance() const { return footprint_clearance_; }
  /// The path found. Empty: the vehicle is there already.
  Path path() const;
  int expansions() const { return expansions_; }
  /// Whether it searches backwards: how far it has come says nothing about the vehicle's surroundings then.
  bool is_from_the_end() const { return from_the_end_; }
  /// All poses that can be reached were tried.
  bool has_tried_all() const { return queue_.empty() && !has_ends_left(); }
  /// Whether both searches have reached some pose.
  bool meets(const CarSearch& other) const;
  /// Whether the search has expanded a pose within this distance of a place.
  bool has_come_to(const Vec2& p_map, double within_m) const;
  /// How far from its start the search has come, in a straight line.
  double reached_m() const { return reached_m_; }

 private:
  struct Node {
    Pose2 T_map;
    double cost_m = 0;
    std::size_t parent = 0;  ///< its own number: the search began here
    Arc arc;                 ///< as the vehicle drives it
    bool closed = false;
  };
  /// An arc, and the vehicle's poses on it that are checked.
  struct Move {
    Arc arc;
    std::vector<Pose2> T_from_driven = {};  ///< relative to its start, from its end on
    std::vector<Pose2> T_to_driven = {};    ///< relative to its end, from its start on
  };
  struct Waiting {
    double estimate_m;
    std::size_t node;
    bool operator<(const Waiting& other) const {
      return estimate_m > other.estimate_m || (estimate_m == other.estimate_m && node > other.node);
    }
  };

  static std::vector<Move> moves_of(const VehicleDescription& vehicle, double steering_share);
  static Move move_along(const Arc& arc);
  void begin(const Pose2& T_map_leave);
  void begin_at(const Pose2& T_map);
  bool is_begin(std::size_t node) const { return nodes_[node].parent == node; }
  bool has_ends_left() const { return ends_.contains(next_end_); }
  int gather_ends(const KnownFloor& floor, int expansions);
  int gather_ends_at(const KnownFloor& floor, const Vec2& p_map);
  bool is_leaving(const Pose2& T_map) const;
  bool is_forbidden_first(const Arc& arc) const;
  bool is_found(const Node& node) const;
  void expand(const KnownFloor& floor, std::size_t node);
  void try_move(const KnownFloor& floor, std::size_t from, const Move& move);
  bool fits_leaving(const KnownFloor& floor, const Pose2& T_map, double clearance_m, double enough_m) const;
  std::optional<double> least_clearance_m(const KnownFloor& floor, const Pose2& T_map_from,
                                          std::span<const Pose2> T_from_passed) const;
  static bool may_drive(const KnownFloor& floor, const Pose2& T_map_from,
                        std::span<const Pose2> T_from_passed, const Arc& arc);
  double cost_of(const Arc& arc, const Arc& before, bool is_first, double clearance_m) const;
  std::uint64_t bin_of(const Pose2& T_map) const;

  CarSearchParams params_;
  FootprintClearance footprint_clearance_;
  std::vector<Move> moves_;
  std::vector<Move> sharp_moves_;  ///< of a search that relaxes its clearance
  IsGoal is_goal_;
  std::function<double(const Vec2&)> left_m_;
  bool from_the_end_ = false;
  IsGoal is_end_;       ///< for a search from all good poses ...
  FloorBox ends_;       ///< ... which are looked for in this box, row by row ...
  FloorCell next_end_;  ///< ... from this cell on; outside the box: all were tried
  Pose2 T_map_leave_;   ///< near this pose there may be little clearance
  State state_ = State::kIdle;
  int expansions_ = 0;
  double reached_m_ = 0;
  RelaxedClearance leave_clearance_;  ///< at that pose
  std::optional<LegDirection> forbidden_first_;
  bool relaxes_clearance_ = false;
  bool crosses_unknown_ = false;
  std::function<bool(const Pose2&)> is_free_;
  std::vector<Node> nodes_;
  std::unordered_map<std::uint64_t, std::size_t> bins_;
  std::vector<Waiting> queue_;
  std::size_t found_ = 0;
};

}  // namespace aisle
