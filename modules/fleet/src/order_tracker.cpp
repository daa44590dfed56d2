#include "aisle/fleet/order_tracker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "aisle/fleet/action_catalog.hpp"

namespace aisle {
namespace {

constexpr double kWaitMax_s = 86400;
constexpr std::size_t kErrorsMax = 20;
constexpr std::size_t kInstantStatesMax = 100;

FleetError order_error(const char* type, const Order& order, std::string description) {
  return {.type = type,
          .description = std::move(description),
          .references = {{"orderId", order.id}, {"orderUpdateId", std::to_string(order.update_id)}}};
}

FleetError node_error(const char* type, const Order& order, const OrderNode& node, std::string description) {
  FleetError error = order_error(type, order, std::move(description));
  error.references.emplace_back("nodeId", node.id);
  return error;
}

/// A number among an action's parameters. Some masters send numbers as texts; those are not taken.
std::optional<double> number_of(const FleetAction& action, const char* key) {
  const auto found = action.parameters.find(key);
  if (found == action.parameters.end() || !found->second.is_number()) return std::nullopt;
  const double value = found->second.get<double>();
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string text_of(const FleetAction& action, const char* key) {
  const auto found = action.parameters.find(key);
  if (found == action.parameters.end() || !found->second.is_string()) return {};
  return found->second.get<std::string>();
}

/// Why an action of an order cannot be done; empty: it can.
std::string why_not_done(const FleetAction& action) {
  if (catalog_action(action.type, false) == nullptr)
    return fmt::format("action '{}' is unknown; nodes can have '{}'", action.type, kWaitAction);
  const auto duration_s = number_of(action, "duration");
  if (!duration_s || *duration_s < 0 || *duration_s > kWaitMax_s)
    return fmt::format("action '{}' needs a duration from 0 to {} s", action.type, kWaitMax_s);
  return {};
}

}  // namespace

OrderTracker::OrderTracker(FleetSite site, double reach_m) : site_(std::move(site)), reach_m_(reach_m) {}

double OrderTracker::reach_m(const OrderNode& node) const {
  return std::max(node.deviation_m, reach_m_);
}

bool OrderTracker::is_active() const {
  return !state_.nodes.empty() || !running_.empty() || !cancelling_.empty();
}

void OrderTracker::take(const Order& order, const std::optional<Pose2>& T_map_vehicle) {
  const bool is_update = !state_.order_id.empty() && order.id == state_.order_id;
  // The master may send again what it has not seen in a state yet.
  if (is_update && order.update_id == state_.update_id) return;
  Order located = order;
  locate_nodes(located);
  auto error = is_update ? why_no_continuation(located) : why_no_start(located, T_map_vehicle);
  if (!error) error = why_not(located);
  if (error) {
    ++orders_refused_;
    return report(std::move(*error));
  }
  order_errors_.clear();
  blocked_.clear();
  is_done_ = false;
  if (is_update) {
    continue_with(std::move(located));
  } else {
    begin(std::move(located), T_map_vehicle);
  }
  refresh_errors();
  refresh_base_request();
  end_if_done();
}

/// Nodes that the order does not place are where the building has them.
void OrderTracker::locate_nodes(Order& order) const {
  for (OrderNode& node : order.nodes) {
    if (!node.p_map) node.p_map = site_.node(node.id);
  }
}

/// What is wrong with an order by itself.
std::optional<FleetError> OrderTracker::why_not(const Order& order) const {
  for (const OrderNode& node : order.nodes) {
    if (!node.p_map)
      return node_error("noRouteError", order, node,
                        "the node has no position, and the building has no such node");
    if (!node.map_id.empty() && node.map_id != site_.map_id)
      return node_error(
          "noRouteError", order, node,
          fmt::format("is on the map '{}', but the vehicle is on '{}'", node.map_id, site_.map_id));
    if (const std::string why = site_.why_not(*node.p_map); !why.empty())
      return node_error("noRouteError", order, node, why);
    for (const FleetAction& one : node.actions) {
      if (const std::string why = why_not_done(one); !why.empty())
        return node_error("orderError", order, node, why);
    }
  }
  for (const OrderEdge& edge : order.edges) {
    if (edge.actions.empty()) continue;
    FleetError error = order_error("orderError", order, "no action can be done while driving an edge");
    error.references.emplace_back("edgeId", edge.id);
    return error;
  }
  return std::nullopt;
}

std::optional<FleetError> OrderTracker::why_no_start(const Order& order,
                                                     const std::optional<Pose2>& T_map_vehicle) const {
  if (is_active())
    return order_error(
        "orderError", order,
        fmt::format("order '{}' is not done; it can be updated or cancelled", state_.order_id));
  if (!T_map_vehicle) return order_error("noRouteError", order, "the vehicle does not know where it is");
  const OrderNode& first = order.nodes.front();
  if (first.id == state_.last_node_id || !first.p_map) return std::nullopt;
  const double off_m = (*first.p_map - T_map_vehicle->position()).norm();
  if (off_m <= reach_m(first)) return std::nullopt;
  return node_error(
      "noRouteError", order, first,
      fmt::format("the order begins {:.1f} m from the vehicle; {:.1f} m are allowed", off_m, reach_m(first)));
}

std::optional<FleetError> OrderTracker::why_no_continuation(const Order& order) const {
  if (order.update_id < state_.update_id)
    return order_error("orderUpdateError", order, fmt::format("update {} came before", state_.update_id));
  if (was_cancelled_ || !cancelling_.empty())
    return order_error("orderUpdateError", order, "the order was cancelled");
  std::string end_id = state_.last_node_id;
  std::uint32_t end_sequence = state_.last_node_sequence;
  for (const OrderNode& node : state_.nodes) {
    if (!node.released) break;
    end_id = node.id;
    end_sequence = node.sequence;
  }
  const OrderNode& first = order.nodes.front();
  if (first.id == end_id && first.sequence == end_sequence) return std::nullopt;
  return node_error("orderUpdateError", order, first,
                    fmt::format("begins at node '{}' ({}), but the base ends at '{}' ({})", first.id,
                                first.sequence, end_id, end_sequence));
}

void OrderTracker::begin(Order order, const std::optional<Pose2>& T_map_vehicle) {
  state_.order_id = order.id;
  state_.update_id = order.update_id;
  state_.zone_set_id = order.zone_set_id;
  state_.nodes = std::move(order.nodes);
  state_.edges = std::move(order.edges);
  was_cancelled_ = false;
  std::erase_if(state_.actions, [](const ActionState& one) { return one.is_over(); });
  std::erase_if(is_instant_, [this](const auto& one) { return action(one.first) == nullptr; });
  for (const OrderNode& node : state_.nodes) add_actions(node);
  p_map_last_node_ = T_map_vehicle->position();
  const OrderNode& first = state_.nodes.front();
  if ((*first.p_map - T_map_vehicle->position()).norm() <= reach_m(first)) arrive();
}

void OrderTracker::continue_with(Order order) {
  state_.update_id = order.update_id;
  if (!order.zone_set_id.empty()) state_.zone_set_id = order.zone_set_id;
  drop_horizon();
  OrderNode& stitched = order.nodes.front();
  add_actions(stitched);
  if (state_.nodes.empty()) {
    begin_actions(stitched);
  } else {
    auto& actions = state_.nodes.back().actions;
    for (FleetAction& one : stitched.actions) {
      const bool is_there = std::any_of(actions.begin(), actions.end(),
                                        [&](const FleetAction& other) { return other.id == one.id; });
      if (!is_there) actions.push_back(std::move(one));
    }
  }
  for (std::size_t i = 1; i < order.nodes.size(); ++i) {
    add_actions(order.nodes[i]);
    state_.nodes.push_back(std::move(order.nodes[i]));
  }
  std::move(order.edges.begin(), order.edges.end(), std::back_inserter(state_.edges));
}

void OrderTracker::drop_horizon() {
  std::set<std::string> dropped;
  for (const OrderNode& node : state_.nodes) {
    if (node.released) continue;
    for (const FleetAction& one : node.actions) dropped.insert(one.id);
  }
  std::erase_if(state_.actions, [&](const ActionState& one) { return dropped.contains(one.id); });
  std::erase_if(state_.nodes, [](const OrderNode& node) { return !node.released; });
  std::erase_if(state_.edges, [](const OrderEdge& edge) { return !edge.released; });
}

void OrderTracker::add_actions(const OrderNode& node) {
  for (const FleetAction& one : node.actions) {
    if (action(one.id) != nullptr) continue;
    state_.actions.push_back({.id = one.id, .type = one.type, .status = Status::kWaiting, .result = {}});
    is_instant_[one.id] = false;
  }
}

void OrderTracker::begin_actions(const OrderNode& node) {
  for (const FleetAction& one : node.actions) {
    const ActionState* const known = action(one.id);
    if (known == nullptr || known->status != Status::kWaiting) continue;
    set(one.id, Status::kInitializing);
    running_.push_back({one.id, one.blocking, number_of(one, "duration").value_or(0)});
  }
}

void OrderTracker::arrive() {
  if (state_.nodes.empty() || !state_.nodes.front().released) return;
  const OrderNode node = std::move(state_.nodes.front());
  state_.nodes.erase(state_.nodes.begin());
  std::erase_if(state_.edges, [&](const OrderEdge& edge) { return edge.sequence < node.sequence; });
  state_.last_node_id = node.id;
  state_.last_node_sequence = node.sequence;
  p_map_last_node_ = node.p_map;
  blocked_.clear();
  begin_actions(node);
  refresh_errors();
  refresh_base_request();
  end_if_done();
}

void OrderTracker::end_if_done() {
  if (is_done_ || is_active()) return;
  is_done_ = true;
  ++orders_done_;
}

bool OrderTracker::is_blocked_by_action() const {
  return std::any_of(running_.begin(), running_.end(),
                     [](const Running& one) { return one.blocking != FleetAction::Blocking::kNone; });
}

std::optional<FleetTarget> OrderTracker::target() const {
  if (state_.is_paused || !cancelling_.empty() || !positioning_.empty() || is_blocked_by_action())
    return std::nullopt;
  if (state_.nodes.empty() || !state_.nodes.front().released) return std::nullopt;
  const OrderNode& node = state_.nodes.front();
  FleetTarget target{.order_id = state_.order_id,
                     .sequence = node.sequence,
                     .p_map = *node.p_map,
                     .p_map_from = p_map_last_node_.value_or(*node.p_map),
                     .speed_max_mps = std::nullopt};
  for (const OrderEdge& edge : state_.edges) {
    if (edge.sequence + 1 == node.sequence) target.speed_max_mps = edge.speed_max_mps;
  }
  return target;
}

void OrderTracker::block(const std::string& why) {
  blocked_ = why;
  refresh_errors();
}

void OrderTracker::fail(const std::string& why) {
  failed_ = why;
  refresh_errors();
}

void OrderTracker::refuse(const std::string& topic, const Problems& problems) {
  if (topic == "order") ++orders_refused_;
  FleetError error{
      .type = "validationError", .description = to_string(problems), .references = {{"topic", topic}}};
  for (const Problem& problem : problems) {
    if (!problem.where.key.empty()) error.references.emplace_back("key", problem.where.key);
  }
  report(std::move(error));
}

void OrderTracker::take(const std::vector<FleetAction>& instant_actions) {
  for (const FleetAction& one : instant_actions) {
    if (action(one.id) != nullptr) continue;  // sent again
    state_.actions.push_back({.id = one.id, .type = one.type, .status = Status::kWaiting, .result = {}});
    is_instant_[one.id] = true;
    take_instant(one);
  }
  // A master that asks for the state each second must not let the state grow.
  auto instants = static_cast<std::size_t>(
      std::count_if(is_instant_.begin(), is_instant_.end(), [](const auto& one) { return one.second; }));
  std::erase_if(state_.actions, [&](const ActionState& one) {
    if (instants <= kInstantStatesMax || !one.is_over() || !is_instant_[one.id]) return false;
    --instants;
    is_instant_.erase(one.id);
    return true;
  });
}

void OrderTracker::take_instant(const FleetAction& one) {
  if (one.type == "startPause") {
    state_.is_paused = true;
    set(one.id, Status::kRunning);
    pausing_.push_back(one.id);
  } else if (one.type == "stopPause") {
    state_.is_paused = false;
    for (const std::string& id : std::exchange(pausing_, {}))
      set(id, Status::kFailed, "stopPause came before");
    set(one.id, Status::kFinished);
  } else if (one.type == "cancelOrder") {
    begin_cancelling(one);
  } else if (one.type == "stateRequest") {
    wants_state_ = true;
    set(one.id, Status::kFinished);
  } else if (one.type == "factsheetRequest") {
    wants_factsheet_ = true;
    set(one.id, Status::kFinished);
  } else if (one.type == "initPosition") {
    const auto x = number_of(one, "x"), y = number_of(one, "y"), theta = number_of(one, "theta");
    const std::string map_id = text_of(one, "mapId");
    if (!x || !y || !theta) return set(one.id, Status::kFailed, "needs the numbers x, y and theta");
    if (!map_id.empty() && map_id != site_.map_id)
      return set(one.id, Status::kFailed, fmt::format("the map is '{}'", site_.map_id));
    if (is_active()) return set(one.id, Status::kFailed, "an order is under way");
    if (!positioning_.empty()) return set(one.id, Status::kFailed, "another one is being checked");
    positioning_ = one.id;
    initial_pose_ = FleetInitialPose{{*x, *y, wrap_angle(*theta)}, text_of(one, "lastNodeId")};
    last_node_id_asked_ = initial_pose_->last_node_id;
    set(one.id, Status::kRunning);
  } else {
    set(one.id, Status::kFailed, "unknown action");
  }
}

void OrderTracker::begin_cancelling(const FleetAction& one) {
  if (!is_active()) {
    set(one.id, Status::kFailed, "there is no order to cancel");
    report({.type = "noOrderToCancel",
            .description = "there is no order to cancel",
            .references = {{"actionId", one.id}}});
    return;
  }
  if (!cancelling_.empty()) return set(one.id, Status::kFailed, "it is being cancelled");
  cancelling_ = one.id;
  set(one.id, Status::kRunning);
  running_.clear();
  for (ActionState& other : state_.actions) {
    if (!is_instant_[other.id] && !other.is_over()) set(other.id, Status::kFailed, "the order was cancelled");
  }
}

void OrderTracker::end_cancelling() {
  state_.nodes.clear();
  state_.edges.clear();
  was_cancelled_ = true;
  is_done_ = true;
  blocked_.clear();
  set(std::exchange(cancelling_, {}), Status::kFinished);
  refresh_errors();
  refresh_base_request();
}

void OrderTracker::step(double stamp_s, bool is_standing) {
  const double elapsed_s = stamp_s_ ? std::max(0.0, stamp_s - *stamp_s_) : 0;
  stamp_s_ = stamp_s;
  if (is_standing) {
    for (const std::string& id : std::exchange(pausing_, {})) set(id, Status::kFinished);
    if (!cancelling_.empty()) end_cancelling();
  }
  run_actions(elapsed_s, is_standing);
  end_if_done();
}

/// Actions of a node run one after the other, which each kind of blocking allows.
void OrderTracker::run_actions(double elapsed_s, bool is_standing) {
  if (running_.empty()) return;
  Running& one = running_.front();
  if (state_.is_paused) return set(one.id, Status::kPaused);
  if (one.blocking != FleetAction::Blocking::kNone && !is_standing) return;
  const ActionState* const known = action(one.id);
  if (known != nullptr && known->status == Status::kRunning) one.left_s -= elapsed_s;
  set(one.id, Status::kRunning);
  if (one.left_s > 0) return;
  set(one.id, Status::kFinished);
  running_.erase(running_.begin());
}

bool OrderTracker::take_state_request() {
  return std::exchange(wants_state_, false);
}

bool OrderTracker::take_factsheet_request() {
  return std::exchange(wants_factsheet_, false);
}

std::optional<FleetInitialPose> OrderTracker::take_initial_pose() {
  return std::exchange(initial_pose_, std::nullopt);
}

void OrderTracker::settle_initial_pose(const std::string& why_not) {
  if (positioning_.empty()) return;
  set(std::exchange(positioning_, {}), why_not.empty() ? Status::kFinished : Status::kFailed, why_not);
  if (!why_not.empty()) return;
  state_.last_node_id = std::exchange(last_node_id_asked_, {});
  state_.last_node_sequence = 0;
  p_map_last_node_.reset();
}

ActionState* OrderTracker::action(const std::string& id) {
  const auto found = std::find_if(state_.actions.begin(), state_.actions.end(),
                                  [&](const ActionState& one) { return one.id == id; });
  return found == state_.actions.end() ? nullptr : &*found;
}

void OrderTracker::set(const std::string& action_id, Status status, const std::string& result) {
  ActionState* const known = action(action_id);
  if (known == nullptr) return;
  known->status = status;
  known->result = result;
}

void OrderTracker::report(FleetError error) {
  std::erase(order_errors_, error);
  order_errors_.push_back(std::move(error));
  if (order_errors_.size() > kErrorsMax) order_errors_.erase(order_errors_.begin());
  refresh_errors();
}

void OrderTracker::refresh_errors() {
  state_.errors = order_errors_;
  if (!blocked_.empty())
    state_.errors.push_back(
        {.type = "pathBlocked", .description = blocked_, .references = {{"orderId", state_.order_id}}});
  if (!failed_.empty())
    state_.errors.push_back(
        {.type = "vehicleError", .is_fatal = true, .description = failed_, .references = {}});
}

void OrderTracker::refresh_base_request() {
  const auto released = std::count_if(state_.nodes.begin(), state_.nodes.end(),
                                      [](const OrderNode& node) { return node.released; });
  state_.wants_base = released <= 1 && static_cast<std::size_t>(released) < state_.nodes.size();
}

}  // namespace aisle
