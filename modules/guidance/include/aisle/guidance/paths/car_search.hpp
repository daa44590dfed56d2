#pragma once
/// Paths for a vehicle that cannot go sideways: a search over poses, forwards and backwards, along arcs that
/// its wheels can drive, with its whole footprint kept on known free floor.

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
  double steering_share = 0.85;      ///< of the wheels' range that paths use; the rest is for keeping to them
  double reverse_factor = 1.5;       ///< what path driven backwards costs
  double cusp_m = 0.8;               ///< what a change of direction costs
  double clearance_wanted_m = 0.35;  ///< less room than this on its sides costs
  double narrow_factor = 2;          ///< so much distance more, where there is none
  double heuristic_weight =
      1.4;              ///< path that is left counts so much: finds sooner what may be a little longer
  double stage_m = 12;  ///< what is much farther away is not searched at once
  int expansions_max = 200000;  ///< poses looked at before the search gives up

  void describe(FieldList& fields);
};

/// One search, which goes on in portions.
class CarSearch {
 public:
  enum class State { kIdle, kSearching, kFound, kNone };
  using IsGoal = std::function<bool(const Pose2& T_map_vehicle)>;

  CarSearch(const CarSearchParams& params, const VehicleDescription& vehicle);

  /// From where the vehicle stands to a pose that is good enough.
  /// @param left_m  how far it still is from a place, at least; guides the search
  void look_for(const Pose2& T_map_vehicle, IsGoal is_goal, std::function<double(const Vec2&)> left_m);

  /// From about where the vehicle stands to exactly a pose: searched from its end, so that what is missing is
  /// missing at the start, where the steering makes up for it.
  /// @param left_m  how far it is from the vehicle to a place, at least
  void look_for_path_to(const Pose2& T_map_goal, const Pose2& T_map_vehicle,
                        std::function<double(const Vec2&)> left_m);

  /// From about where the vehicle stands to any pose that is good enough and lies in a box: searched from all
  /// of them at once. Where they are shut off from the vehicle, few poses are to be looked at to know that.
  /// @param left_m  how far it is from the vehicle to a place, at least
  void look_for_path_to_any(IsGoal is_good, const FloorBox& places, const Pose2& T_map_vehicle,
                            std::function<double(const Vec2&)> left_m);

  /// Of the search that was begun: the path must not begin forwards (1) or backwards (-1), where something is
  /// in the path that the floor does not show.
  void forbid_first(int direction) { forbidden_first_ = direction; }

  /// Of the search that was begun: poses that do not pass are never taken, whatever the floor shows.
  void keep_to(std::function<bool(const Pose2& T_map_vehicle)> is_free) { is_free_ = std::move(is_free); }

  /// Of the search that was begun: sharper bends will do, and less room than the margin. For where there is
  /// no path otherwise, as both make it harder to keep to what was found.
  void relax_clearance() { relaxes_clearance_ = true; }

  /// Looks at so many poses more, or fewer where one takes longer.
  State advance(const FloorGrid& floor, const FloorClearance& clearance, int expansions);

  /// Forgets what was searched.
  void stop() { state_ = State::kIdle; }

  State state() const { return state_; }
  const FootprintClearance& footprint_clearance() const { return footprint_clearance_; }
  /// What was found. Empty: the vehicle is there already.
  Path path() const;
  int expansions() const { return expansions_; }
  /// There is nowhere else to look.
  bool has_tried_all() const { return queue_.empty() && !has_ends_left(); }
  /// Some pose has been come upon by both searches.
  bool meets(const CarSearch& other) const;
  /// Some pose that was looked at lies so near to a place.
  bool has_come_to(const Vec2& p_map, double within_m) const;
  /// How far from its start the search has come, as the crow flies.
  double reached_m() const { return reached_m_; }

 private:
  struct Node {
    Pose2 T_map;
    double cost_m = 0;
    std::size_t parent = 0;  ///< itself: the search began here
    Arc arc;                 ///< as the vehicle drives it
    bool closed = false;
  };
  /// An arc, and the vehicle's poses on it that are looked at.
  struct Move {
    Arc arc;
    std::vector<Pose2> T_from_driven = {};  ///< from where it begins, its end first
    std::vector<Pose2> T_to_driven = {};    ///< from where it ends, its beginning first
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
  int gather_ends(const FloorGrid& floor, const FloorClearance& clearance, int expansions);
  int gather_ends_at(const FloorGrid& floor, const FloorClearance& clearance, const Vec2& p_map);
  bool is_leaving(const Pose2& T_map) const;
  bool is_found(const Node& node) const;
  void expand(const FloorGrid& floor, const FloorClearance& clearance, std::size_t node);
  void try_move(const FloorGrid& floor, const FloorClearance& clearance, std::size_t from, const Move& move);
  std::optional<double> least_clearance_m(const FloorGrid& floor, const FloorClearance& clearance,
                                          const Pose2& T_map_from,
                                          std::span<const Pose2> T_from_passed) const;
  double cost_of(const Arc& arc, const Arc& before, bool is_first, double clearance_m) const;
  std::uint64_t bin_of(const Pose2& T_map) const;

  CarSearchParams params_;
  FootprintClearance footprint_clearance_;
  std::vector<Move> moves_;
  std::vector<Move> sharp_moves_;  ///< of a search that relaxes its clearance
  IsGoal is_goal_;
  std::function<double(const Vec2&)> left_m_;
  bool from_the_end_ = false;
  IsGoal is_end_;       ///< of a search from any of its ends ...
  FloorBox ends_;       ///< ... in which poses are tried for that, row by row ...
  FloorCell next_end_;  ///< ... from here on; outside: all were
  Pose2 T_map_leave_;   ///< about which there may be little room
  State state_ = State::kIdle;
  int expansions_ = 0;
  double reached_m_ = 0;
  RelaxedClearance leave_clearance_;  ///< room there
  int forbidden_first_ = 0;
  bool relaxes_clearance_ = false;
  std::function<bool(const Pose2&)> is_free_;
  std::vector<Node> nodes_;
  std::unordered_map<std::uint64_t, std::size_t> bins_;
  std::vector<Waiting> queue_;
  std::size_t found_ = 0;
};

}  // namespace aisle
