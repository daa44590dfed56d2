#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "aisle/core/problem.hpp"
#include "aisle/fleet/fleet_link.hpp"
#include "aisle/fleet/fleet_state.hpp"
#include "aisle/fleet/order_tracker.hpp"

namespace aisle {

/// Which vehicle of which maker this is: the middle of its topics.
struct FleetIdentity {
  std::string manufacturer = "aisle";
  std::string serial = "0001";

  /// Empty, or with what MQTT does not allow in a topic's level.
  Problems problems() const;
  /// "uagv/v2/MANUFACTURER/SERIAL/order"
  std::string topic(const std::string& last) const;
};

/// A vehicle's part of VDA 5050 2.1: reads what has come, keeps the order, and sends what others wait for.
class FleetClient {
 public:
  /// @param link       must outlive the client
  /// @param timestamp  what time it is: ISO 8601, UTC
  FleetClient(FleetIdentity identity, OrderTracker tracker, VehicleDescription vehicle, FleetLink& link,
              std::function<std::string()> timestamp);

  /// Once a cycle. The state is sent when it changes, after each new connection and at least every 30 s.
  void exchange(double stamp_s, const VehicleState& vehicle);
  /// Says that the vehicle leaves.
  void leave();

  OrderTracker& tracker() { return tracker_; }
  const OrderTracker& tracker() const { return tracker_; }

 private:
  enum Topic { kState, kVisualization, kConnection, kFactsheet };

  FleetHeader next_header(Topic topic);
  void read(const FleetMessage& message, const VehicleState& vehicle);
  void greet();
  void send_state(double stamp_s, const VehicleState& vehicle);

  FleetIdentity identity_;
  OrderTracker tracker_;
  VehicleDescription vehicle_;
  FleetLink& link_;
  std::function<std::string()> timestamp_;
  std::array<std::uint32_t, 4> sent_ = {};
  std::size_t greeted_ = 0;  ///< connections
  std::optional<OrderState> order_sent_;
  bool driving_sent_ = false, touching_sent_ = false, located_sent_ = false;
  double state_sent_s_ = 0, visualized_s_ = 0;
};

}  // namespace aisle
