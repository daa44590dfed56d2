#include "aisle/guidance/paths/car_search.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr double kSearchStep_m = 0.25;
constexpr double kSpotTurn_rad = 15 * kDegree;
constexpr double kBin_m = 0.1;
constexpr double kHeadings = 48;
constexpr double kCheckEvery_m = 0.13;
constexpr double kNear_m = 0.12;  // between the vehicle and the start of a path searched from its end
constexpr double kNear_rad = 7 * kDegree;
constexpr double kBendCost = 0.1;        // of the sharpest bend, per metre
constexpr double kLeave_m = 2;           // within this distance of its start a vehicle may barely fit ...
constexpr double kTightCost = 4;         // of path with less clearance than the margin
constexpr double kLeastMargin_m = 0.03;  // ... or keep this margin instead, as with relaxed clearance
constexpr double kSharpShare = 0.97;     // of the steering range, with relaxed clearance
constexpr double kEndsEvery_m = 0.05;    // between the places where ends are tried, in all headings
constexpr int kPlaceExpansions = 4;      // costs: checking a place for free floor counts as this many ...
constexpr int kEndsAnExpansion = 4;      // ... and trying this many poses there counts as one
constexpr int kLeaveExpansions = 2;      // expanding a pose where the vehicle may barely fit counts as two

/// The arcs that a vehicle can drive in one step.
std::vector<Arc> arcs_of(const VehicleDescription& vehicle, double steering_share) {
  std::vector<Arc> arcs;
  const double curvature_per_m =
      vehicle.is_differential
          ? 0.0
          : std::tan(vehicle.limits.steering_max_rad * steering_share) / vehicle.front_steered.wheelbase_m;
  for (const double length_m : {kSearchStep_m, -kSearchStep_m}) {
    for (const double share : {0.0, 0.5, -0.5, 1.0, -1.0}) {
      if (share == 0 || curvature_per_m > 0) arcs.push_back({length_m, share * curvature_per_m * length_m});
    }
  }
  if (vehicle.is_differential) {
    arcs.push_back({0, kSpotTurn_rad});
    arcs.push_back({0, -kSpotTurn_rad});
  }
  return arcs;
}

bool changes_direction(const Arc& a, const Arc& b) {
  return direction_of(a) != direction_of(b);
}

CarSearch::IsGoal is_near(const Pose2& T_map_vehicle) {
  return [T_map_vehicle](const Pose2& T_map) {
    return (T_map.position() - T_map_vehicle.position()).norm() < kNear_m &&
           std::abs(wrap_angle(T_map.theta - T_map_vehicle.theta)) < kNear_rad;
  };
}

/// Merges consecutive arcs of equal curvature.
void append(std::vector<PathPiece>& pieces, const Pose2& T_map_start, const Arc& arc) {
  if (!pieces.empty()) {
    Arc& last = pieces.back().arc;
    const bool same_bend = !changes_direction(last, arc) &&
                           std::abs(last.turn_rad * arc.length_m - arc.turn_rad * last.length_m) < 1e-9;
    if (same_bend) {
      last = {last.length_m + arc.length_m, last.turn_rad + arc.turn_rad};
      return;
    }
  }
  const Pose2 T_map = pieces.empty() ? T_map_start : pieces.back().end();
  pieces.push_back({T_map, arc});
}

}  // namespace

void CarSearchParams::describe(FieldList& fields) {
  fields.real("margin_m", margin_m, {0, 1}, "kept free around the footprint");
  fields.real("steering_share", steering_share, {0.2, 1}, "of the steering range that paths use");
  fields.real("reverse_factor", reverse_factor, {1, 10}, "cost of path driven backwards");
  fields.real("cusp_m", cusp_m, {0, 20}, "cost of a change of direction");
  fields.real("clearance_wanted_m", clearance_wanted_m, {0, 2},
              "less clearance than this around the footprint costs");
  fields.real("narrow_factor", narrow_factor, {0, 20}, "cost factor added where there is no clearance");
  fields.real("heuristic_weight", heuristic_weight, {1, 5},
              "weight of the path left, in the search's estimate");
  fields.real("stage_m", stage_m, {3, 100}, "paths that are much longer are planned in stages");
  fields.count("expansions_max", expansions_max, {100, 1000000}, "poses expanded before a search gives up");
}

CarSearch::CarSearch(const CarSearchParams& params, const VehicleDescription& vehicle)
    : params_(params),
      footprint_clearance_(vehicle.footprint, params.margin_m),
      moves_(moves_of(vehicle, params.steering_share)),
      sharp_moves_(moves_of(vehicle, std::max(params.steering_share, kSharpShare))) {}

std::vector<CarSearch::Move> CarSearch::moves_of(const VehicleDescription& vehicle, double steering_share) {
  std::vector<Move> moves;
  for (const Arc& arc : arcs_of(vehicle, steering_share)) moves.push_back(move_along(arc));
  return moves;
}

/// Poses for both search directions. The arc's far end comes first, where most collisions are.
CarSearch::Move CarSearch::move_along(const Arc& arc) {
  Move move{.arc = arc};
  const int checks = std::max(1, static_cast<int>(std::ceil(std::abs(arc.length_m) / kCheckEvery_m)));
  for (int i = checks; i > 0; --i) {
    const double share = static_cast<double>(i) / checks;
    move.T_from_driven.push_back(end_pose({share * arc.length_m, share * arc.turn_rad}));
    move.T_to_driven.push_back(end_pose({-share * arc.length_m, -share * arc.turn_rad}));
  }
  return move;
}

void CarSearch::look_for(const Pose2& T_map_vehicle, IsGoal is_goal,
                         std::function<double(const Vec2&)> left_m) {
  is_goal_ = std::move(is_goal);
  left_m_ = std::move(left_m);
  from_the_end_ = false;
  begin(T_map_vehicle);
  begin_at(T_map_vehicle);
}

void CarSearch::look_for_path_to(const Pose2& T_map_goal, const Pose2& T_map_vehicle,
                                 std::function<double(const Vec2&)> left_m) {
  is_goal_ = is_near(T_map_vehicle);
  left_m_ = std::move(left_m);
  from_the_end_ = true;
  begin(T_map_goal);
  begin_at(T_map_goal);
}

void CarSearch::look_for_path_to_any(IsGoal is_good, const FloorBox& places, const Pose2& T_map_vehicle,
                                     std::function<double(const Vec2&)> left_m) {
  is_goal_ = is_near(T_map_vehicle);
  left_m_ = std::move(left_m);
  from_the_end_ = true;
  begin(T_map_vehicle);
  is_end_ = std::move(is_good);
  ends_ = places;
  next_end_ = places.low;
}

void CarSearch::begin(const Pose2& T_map_leave) {
  nodes_.clear();
  bins_.clear();
  queue_.clear();
  expansions_ = 0;
  reached_m_ = 0;
  forbidden_first_.reset();
  relaxes_clearance_ = crosses_unknown_ = false;
  is_free_ = nullptr;
  ends_ = {};
  T_map_leave_ = T_map_leave;
  state_ = State::kSearching;
}

void CarSearch::begin_at(const Pose2& T_map) {
  const std::size_t node = nodes_.size();
  nodes_.push_back({.T_map = T_map, .parent = node, .arc = {}});
  bins_[bin_of(T_map)] = node;
  queue_.push_back({params_.heuristic_weight * left_m_(T_map.position()), node});
  std::push_heap(queue_.begin(), queue_.end());
}

/// @return how many expansions that counts as
int CarSearch::gather_ends(const KnownFloor& floor, int expansions) {
  const int every = std::max(1, static_cast<int>(kEndsEvery_m / floor.grid().cell_m()));
  int used = 0;
  while (has_ends_left() && used < expansions) {
    if (floor.clearance().to_doubtful_m(next_end_) > 0)
      used += kPlaceExpansions + gather_ends_at(floor, floor.grid().centre(next_end_)) / kEndsAnExpansion;
    next_end_.x += every;
    if (next_end_.x >= ends_.end.x) next_end_ = {ends_.low.x, next_end_.y + every};
  }
  return used;
}

/// @return how many poses were tried
int CarSearch::gather_ends_at(const KnownFloor& floor, const Vec2& p_map) {
  constexpr Pose2 kThere[] = {{}};
  int tried = 0;
  for (int heading = 0; heading < kHeadings; ++heading) {
    const Pose2 T_map{p_map.x(), p_map.y(), (heading + 0.5) / kHeadings * 2 * kPi - kPi};
    if (bins_.contains(bin_of(T_map)) || !least_clearance_m(floor, T_map, kThere)) continue;
    if (is_end_(T_map)) begin_at(T_map);
    ++tried;
  }
  return tried;
}

bool CarSearch::is_leaving(const Pose2& T_map) const {
  return (T_map.position() - T_map_leave_.position()).norm() < kLeave_m;
}

bool CarSearch::is_forbidden_first(const Arc& arc) const {
  return forbidden_first_ == direction_of(arc);
}

bool CarSearch::is_found(const Node& node) const {
  const bool begins_forbidden = from_the_end_ && is_forbidden_first(node.arc);
  return !begins_forbidden && is_goal_(node.T_map);
}

CarSearch::State CarSearch::advance(const KnownFloor& floor, int expansions) {
  leave_clearance_ = footprint_clearance_.relaxed_clearance(floor, T_map_leave_);
  expansions -= gather_ends(floor, expansions);
  while (expansions > 0 && state_ == State::kSearching) {
    if (queue_.empty() || expansions_ >= params_.expansions_max) {
      state_ = State::kNone;
      break;
    }
    std::pop_heap(queue_.begin(), queue_.end());
    const std::size_t node = queue_.back().node;
    queue_.pop_back();
    if (nodes_[node].closed) continue;
    nodes_[node].closed = true;
    ++expansions_;
    reached_m_ = std::max(reached_m_, (nodes_[node].T_map.position() - T_map_leave_.position()).norm());
    if (is_found(nodes_[node])) {
      found_ = node;
      state_ = State::kFound;
      break;
    }
    expand(floor, node);
    expansions -= is_leaving(nodes_[node].T_map) ? kLeaveExpansions : 1;
  }
  return state_;
}

bool CarSearch::has_come_to(const Vec2& p_map, double within_m) const {
  return std::any_of(nodes_.begin(), nodes_.end(), [&](const Node& node) {
    return node.closed && (node.T_map.position() - p_map).norm() < within_m;
  });
}

bool CarSearch::meets(const CarSearch& other) const {
  return std::any_of(bins_.begin(), bins_.end(),
                     [&](const auto& bin) { return other.bins_.contains(bin.first); });
}

void CarSearch::expand(const KnownFloor& floor, std::size_t node) {
  for (const Move& move : relaxes_clearance_ ? sharp_moves_ : moves_) try_move(floor, node, move);
}

void CarSearch::try_move(const KnownFloor& floor, std::size_t from, const Move& move) {
  const Arc& arc = move.arc;
  if (!from_the_end_ && is_begin(from) && is_forbidden_first(arc)) return;
  const std::vector<Pose2>& T_from_passed = from_the_end_ ? move.T_to_driven : move.T_from_driven;
  const Pose2 T_map = nodes_[from].T_map * T_from_passed.front();
  const std::uint64_t bin = bin_of(T_map);
  const auto there = bins_.find(bin);
  if (there != bins_.end() && nodes_[there->second].closed) return;
  const auto cost_with = [&](double clearance_m) {
    return nodes_[from].cost_m + cost_of(arc, nodes_[from].arc, is_begin(from), clearance_m);
  };
  const double cost_least_m = cost_with(params_.clearance_wanted_m);
  if (there != bins_.end() && nodes_[there->second].cost_m <= cost_least_m) return;
  if (!may_drive(floor, nodes_[from].T_map, T_from_passed, arc)) return;
  const auto clearance_m = least_clearance_m(floor, nodes_[from].T_map, T_from_passed);
  if (!clearance_m) return;
  const double cost_m = cost_with(*clearance_m);
  std::size_t node = nodes_.size();
  if (there != bins_.end()) {
    node = there->second;
    if (nodes_[node].cost_m <= cost_m) return;
    nodes_[node] = {T_map, cost_m, from, arc, false};
  } else {
    nodes_.push_back({T_map, cost_m, from, arc, false});
    bins_.emplace(bin, node);
  }
  queue_.push_back({cost_m + params_.heuristic_weight * left_m_(T_map.position()), node});
  std::push_heap(queue_.begin(), queue_.end());
}

/// nullopt if some pose does not fit; negative if there is less clearance than the margin, but still enough.
std::optional<double> CarSearch::least_clearance_m(const KnownFloor& floor, const Pose2& T_map_from,
                                                   std::span<const Pose2> T_from_passed) const {
  const bool may_barely_fit = is_leaving(T_map_from);
  const double enough_m =
      may_barely_fit || relaxes_clearance_ ? std::min(0.0, kLeastMargin_m - params_.margin_m) : 0;
  const double needed_m =
      may_barely_fit ? std::min(enough_m, leave_clearance_.free_m - kClearanceNoise_m) : enough_m;
  double least_m = floor.clearance().far_m();
  for (const Pose2& T_from : T_from_passed) {
    const Pose2 T_map = T_map_from * T_from;
    const double clearance_m = footprint_clearance_.clearance_m(floor, T_map, needed_m);
    const bool fits =
        clearance_m >= enough_m || (may_barely_fit && fits_leaving(floor, T_map, clearance_m, enough_m));
    if (!fits || (is_free_ && !is_free_(T_map))) return std::nullopt;
    least_m = std::min(least_m, clearance_m);
  }
  return least_m;
}

bool CarSearch::fits_leaving(const KnownFloor& floor, const Pose2& T_map, double clearance_m,
                             double enough_m) const {
  if (footprint_clearance_.fits_barely(floor, T_map, clearance_m, leave_clearance_)) return true;
  return crosses_unknown_ && footprint_clearance_.standing_clearance_m(floor, T_map) >= enough_m &&
         footprint_clearance_.lies_on_free_or_unknown(floor, T_map);
}

/// Against no one-way zone, at its start nor at what it passes.
bool CarSearch::may_drive(const KnownFloor& floor, const Pose2& T_map_from,
                          std::span<const Pose2> T_from_passed, const Arc& arc) {
  if (!floor.is_one_way_somewhere() || arc.length_m == 0) return true;
  const Gear gear = gear_of(arc.length_m);
  return floor.may_drive(T_map_from, gear) &&
         std::all_of(T_from_passed.begin(), T_from_passed.end(),
                     [&](const Pose2& T_from) { return floor.may_drive(T_map_from * T_from, gear); });
}

double CarSearch::cost_of(const Arc& arc, const Arc& before, bool is_first, double clearance_m) const {
  const double path_m = arc.length_m == 0 ? std::abs(arc.turn_rad) * 0.3 : std::abs(arc.length_m);
  double cost_m = path_m * (arc.length_m < 0 ? params_.reverse_factor : 1);
  if (clearance_m < params_.clearance_wanted_m)
    cost_m += path_m * params_.narrow_factor * std::min(1.0, 1 - clearance_m / params_.clearance_wanted_m);
  if (clearance_m < 0) cost_m += path_m * kTightCost;
  cost_m += kBendCost * std::abs(arc.turn_rad);
  if (!is_first && changes_direction(arc, before)) cost_m += params_.cusp_m;
  return cost_m;
}

std::uint64_t CarSearch::bin_of(const Pose2& T_map) const {
  constexpr double kOffset = 1 << 20;
  const auto x = static_cast<std::uint64_t>(std::floor(T_map.x / kBin_m) + kOffset);
  const auto y = static_cast<std::uint64_t>(std::floor(T_map.y / kBin_m) + kOffset);
  const auto heading = static_cast<std::uint64_t>(std::floor((T_map.theta + kPi) / (2 * kPi) * kHeadings));
  return (x << 40U) | (y << 16U) | heading;
}

Path CarSearch::path() const {
  std::vector<std::size_t> chain;
  std::size_t node = found_;
  for (; !is_begin(node); node = nodes_[node].parent) chain.push_back(node);
  if (!from_the_end_) std::reverse(chain.begin(), chain.end());
  std::vector<PathPiece> pieces;
  const Pose2& T_map_start = nodes_[from_the_end_ ? found_ : node].T_map;
  for (const std::size_t driven : chain) append(pieces, T_map_start, nodes_[driven].arc);
  return Path(std::move(pieces));
}

}  // namespace aisle
