#pragma once
/// What a vehicle says of itself to its fleet's master control, by VDA 5050 version 2.1.

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "aisle/fleet/order.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

struct ActionState {
  enum class Status { kWaiting, kInitializing, kRunning, kPaused, kFinished, kFailed };
  std::string id, type;
  Status status = Status::kWaiting;
  std::string result;  ///< may be empty

  bool is_over() const { return status == Status::kFinished || status == Status::kFailed; }
  friend bool operator==(const ActionState&, const ActionState&) = default;
};

/// "WAITING", "RUNNING" ...
std::string_view name_of(ActionState::Status status);

struct FleetError {
  std::string type = {};  ///< "validationError", "orderUpdateError" ...
  bool is_fatal = false;  ///< a person must help; else the vehicle goes on or waits for another order
  std::string description = {};
  std::vector<std::pair<std::string, std::string>> references = {};  ///< key and value of what it is about

  friend bool operator==(const FleetError&, const FleetError&) = default;
};

/// The part of a state that orders and actions decide; equal parts need not be sent again.
struct OrderState {
  std::string order_id;  ///< empty: none yet
  std::uint32_t update_id = 0;
  std::string zone_set_id;
  std::string last_node_id;  ///< empty: none yet
  std::uint32_t last_node_sequence = 0;
  std::vector<OrderNode> nodes;  ///< still to be reached
  std::vector<OrderEdge> edges;  ///< still to be left, the one that is driven on included
  std::vector<ActionState> actions;
  std::vector<FleetError> errors;
  bool is_paused = false;
  bool wants_base = false;  ///< the base soon ends, the order does not

  friend bool operator==(const OrderState&, const OrderState&) = default;
};

/// The rest of it.
struct VehicleState {
  std::optional<Pose2> T_map_vehicle = {};  ///< absent: it does not know where it is
  double localisation_score = 0;            ///< 0 .. 1: share of the walls in sight that fit the map
  double speed_mps = 0;
  double turn_rate_rad_s = 0;
  bool is_driving = false;
  bool is_touching = false;  ///< its bumper is pressed
  std::string map_id = {};
};

/// Who sends a message, and which of its topic it is.
struct FleetHeader {
  std::uint32_t id = 0;   ///< counts the messages of one topic
  std::string timestamp;  ///< ISO 8601, UTC
  std::string manufacturer, serial;
};

enum class FleetConnection { kOnline, kOffline, kBroken };

std::string state_json(const FleetHeader& header, const OrderState& order, const VehicleState& vehicle);
std::string visualization_json(const FleetHeader& header, const VehicleState& vehicle);
std::string connection_json(const FleetHeader& header, FleetConnection connection);
std::string factsheet_json(const FleetHeader& header, const VehicleDescription& vehicle);

}  // namespace aisle
