#include "aisle/fleet/fleet_client.hpp"

#include <utility>

#include "aisle/fleet/order_json.hpp"

namespace aisle {
namespace {

constexpr double kStateAtLeastEvery_s = 30;
constexpr double kVisualizationEvery_s = 0.5;

}  // namespace

Problems FleetIdentity::problems() const {
  Problems problems;
  const auto check = [&](const char* key, const std::string& text) {
    if (text.empty()) problems.push_back({{key}, "is empty"});
    if (text.find_first_of("+#/$") != std::string::npos)
      problems.push_back({{key}, "'" + text + "' has one of + # / $, which topics cannot have"});
  };
  check("--manufacturer", manufacturer);
  check("--serial", serial);
  return problems;
}

std::string FleetIdentity::topic(const std::string& last) const {
  return "uagv/v2/" + manufacturer + "/" + serial + "/" + last;
}

FleetClient::FleetClient(FleetIdentity identity, OrderTracker tracker, VehicleDescription vehicle,
                         FleetLink& link, std::function<std::string()> timestamp)
    : identity_(std::move(identity)),
      tracker_(std::move(tracker)),
      vehicle_(std::move(vehicle)),
      link_(link),
      timestamp_(std::move(timestamp)) {}

FleetHeader FleetClient::next_header(Topic topic) {
  return {sent_.at(topic)++, timestamp_(), identity_.manufacturer, identity_.serial};
}

void FleetClient::exchange(double stamp_s, const VehicleState& vehicle) {
  for (const FleetMessage& message : link_.take_received()) read(message, vehicle);
  tracker_.step(stamp_s, !vehicle.is_driving);
  if (!link_.is_connected()) return;
  const bool is_new = link_.connections() != greeted_;
  if (is_new) greet();
  const bool is_asked = tracker_.take_state_request();
  if (tracker_.take_factsheet_request())
    link_.send({"factsheet", factsheet_json(next_header(kFactsheet), vehicle_)}, false);
  const bool is_changed = order_sent_ != tracker_.state() || driving_sent_ != vehicle.is_driving ||
                          touching_sent_ != vehicle.is_touching ||
                          located_sent_ != vehicle.T_map_vehicle.has_value();
  if (is_new || is_asked || is_changed || stamp_s - state_sent_s_ >= kStateAtLeastEvery_s)
    send_state(stamp_s, vehicle);
  if (stamp_s - visualized_s_ < kVisualizationEvery_s) return;
  visualized_s_ = stamp_s;
  link_.send({"visualization", visualization_json(next_header(kVisualization), vehicle)}, false);
}

void FleetClient::read(const FleetMessage& message, const VehicleState& vehicle) {
  if (message.topic == "order") {
    const auto order = read_order(message.json);
    if (!order) return tracker_.refuse(message.topic, order.problems());
    tracker_.take(*order, vehicle.T_map_vehicle);
  } else if (message.topic == "instantActions") {
    const auto actions = read_instant_actions(message.json);
    if (!actions) return tracker_.refuse(message.topic, actions.problems());
    tracker_.take(*actions);
  }
}

/// Who has just come, or comes back, cannot know what was sent before.
void FleetClient::greet() {
  greeted_ = link_.connections();
  link_.send({"connection", connection_json(next_header(kConnection), FleetConnection::kOnline)}, true);
  link_.send({"factsheet", factsheet_json(next_header(kFactsheet), vehicle_)}, true);
}

void FleetClient::send_state(double stamp_s, const VehicleState& vehicle) {
  order_sent_ = tracker_.state();
  driving_sent_ = vehicle.is_driving;
  touching_sent_ = vehicle.is_touching;
  located_sent_ = vehicle.T_map_vehicle.has_value();
  state_sent_s_ = stamp_s;
  link_.send({"state", state_json(next_header(kState), *order_sent_, vehicle)}, false);
}

void FleetClient::leave() {
  if (!link_.is_connected()) return;
  link_.send({"connection", connection_json(next_header(kConnection), FleetConnection::kOffline)}, true);
}

}  // namespace aisle
