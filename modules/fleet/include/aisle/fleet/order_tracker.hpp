#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "aisle/core/problem.hpp"
#include "aisle/fleet/fleet_state.hpp"
#include "aisle/fleet/order.hpp"

namespace aisle {

/// Where orders are driven. Neither function may be empty.
struct FleetSite {
  std::string map_id;
  std::function<std::optional<Vec2>(const std::string& node_id)> node;  ///< nodes that the vehicle knows
  std::function<std::string(const Vec2& p_map)> why_not;  ///< why it cannot be sent there; empty: it can
};

/// The node that the vehicle is to drive to. Targets are equal if the vehicle need not be sent again.
struct FleetTarget {
  std::string order_id;
  std::uint32_t sequence = 0;
  Vec2 p_map = Vec2::Zero();
  Vec2 p_map_from = Vec2::Zero();       ///< start of the edge that leads there
  std::optional<double> speed_max_mps;  ///< of that edge

  bool is_same(const FleetTarget& other) const {
    return sequence == other.sequence && order_id == other.order_id;
  }
};

/// Where somebody says that the vehicle stands.
struct FleetInitialPose {
  Pose2 T_map_vehicle;
  std::string last_node_id;
};

/// The order that a vehicle has, as VDA 5050 2.1 (section 6.6) has it: which messages it takes, what of it is
/// left, what its actions do. It knows no clock, no network and no vehicle: those who drive ask for the
/// target once a cycle and say when it is reached.
class OrderTracker {
 public:
  /// @param reach_m  how near to a node the vehicle can get; nodes may ask for less, and get this
  OrderTracker(FleetSite site, double reach_m);

  /// A new order, or more of the present one. What cannot be taken is an error of the state, and changes
  /// nothing else.
  /// @param T_map_vehicle  where the vehicle is; nullopt: unknown, so no new order can be begun
  void take(const Order& order, const std::optional<Pose2>& T_map_vehicle);
  void take(const std::vector<FleetAction>& instant_actions);
  /// A message that could not be read.
  void refuse(const std::string& topic, const Problems& problems);

  /// A cycle has passed: actions go on. @param is_standing  the vehicle does not move
  void step(double stamp_s, bool is_standing);

  /// The next node of the base; nullopt: the vehicle is to stand where it is.
  std::optional<FleetTarget> target() const;
  /// The vehicle is at the target.
  void arrive();
  /// Why the target cannot be reached now; empty: it can.
  void block(const std::string& why);
  /// What only a person can mend, such as a vehicle that is lost; empty: nothing.
  void fail(const std::string& why);

  /// True once after each request.
  bool take_state_request();
  bool take_factsheet_request();
  /// Once after each request; who takes it answers by `settle_initial_pose`.
  std::optional<FleetInitialPose> take_initial_pose();
  /// @param why_not  empty: the vehicle stands there
  void settle_initial_pose(const std::string& why_not);

  const OrderState& state() const { return state_; }
  /// An order is under way or waits for more of it.
  bool is_active() const;
  std::size_t orders_done() const { return orders_done_; }
  std::size_t orders_refused() const { return orders_refused_; }
  /// How far a node's position may be off, for this node.
  double reach_m(const OrderNode& node) const;

 private:
  using Status = ActionState::Status;

  /// An action of a node that was reached.
  struct Running {
    std::string id;
    FleetAction::Blocking blocking = FleetAction::Blocking::kHard;
    double left_s = 0;
  };

  std::optional<FleetError> why_not(const Order& order) const;
  std::optional<FleetError> why_no_start(const Order& order, const std::optional<Pose2>& T_map) const;
  std::optional<FleetError> why_no_continuation(const Order& order) const;
  void begin(Order order, const std::optional<Pose2>& T_map_vehicle);
  void continue_with(Order order);
  void drop_horizon();
  void add_actions(const OrderNode& node);
  void locate_nodes(Order& order) const;
  void begin_actions(const OrderNode& node);
  void take_instant(const FleetAction& action);
  void begin_cancelling(const FleetAction& action);
  void end_cancelling();
  void run_actions(double elapsed_s, bool is_standing);
  void end_if_done();
  void set(const std::string& action_id, Status status, const std::string& result = {});
  ActionState* action(const std::string& id);
  void report(FleetError error);
  void refresh_errors();
  void refresh_base_request();
  bool is_blocked_by_action() const;

  FleetSite site_;
  double reach_m_;
  OrderState state_;
  std::vector<FleetError> order_errors_;  ///< until an order is taken
  std::string blocked_, failed_;
  std::vector<Running> running_;
  std::map<std::string, bool> is_instant_;  ///< of every action in the state
  std::vector<std::string> pausing_;        ///< actions that are over once the vehicle stands
  std::string cancelling_;                  ///< action; empty: none
  std::string positioning_;                 ///< action; empty: none
  std::optional<FleetInitialPose> initial_pose_;
  std::string last_node_id_asked_;
  std::optional<Vec2> p_map_last_node_;
  std::optional<double> stamp_s_;
  bool was_cancelled_ = false;
  bool is_done_ = true;
  bool wants_state_ = false, wants_factsheet_ = false;
  std::size_t orders_done_ = 0, orders_refused_ = 0;
};

}  // namespace aisle
