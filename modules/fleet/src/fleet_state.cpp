#include "aisle/fleet/fleet_state.hpp"

#include <array>
#include <cmath>

#include "aisle/core/rounded.hpp"
#include "aisle/fleet/action_catalog.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

Json header_json(const FleetHeader& header) {
  return {{"headerId", header.id},
          {"timestamp", header.timestamp},
          {"version", "2.1.0"},
          {"manufacturer", header.manufacturer},
          {"serialNumber", header.serial}};
}

/// One line. What others have sent may be no UTF-8; such bytes are replaced rather than thrown about.
std::string text_of(const Json& message) {
  return message.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json position_json(const Pose2& T, const std::string& map_id) {
  return {{"x", rounded(T.x, 3)}, {"y", rounded(T.y, 3)}, {"theta", rounded(T.theta, 4)}, {"mapId", map_id}};
}

Json node_json(const OrderNode& node, const std::string& map_id) {
  Json json = {{"nodeId", node.id}, {"sequenceId", node.sequence}, {"released", node.released}};
  if (node.p_map) {
    json["nodePosition"] = {{"x", node.p_map->x()}, {"y", node.p_map->y()}, {"mapId", map_id}};
    if (node.heading_rad) json["nodePosition"]["theta"] = *node.heading_rad;
  }
  return json;
}

Json error_json(const FleetError& error) {
  Json references = Json::array();
  for (const auto& [key, value] : error.references)
    references.push_back({{"referenceKey", key}, {"referenceValue", value}});
  return {{"errorType", error.type},
          {"errorReferences", std::move(references)},
          {"errorDescription", error.description},
          {"errorLevel", error.is_fatal ? "FATAL" : "WARNING"}};
}

Json own_position_json(const VehicleState& vehicle) {
  Json position = position_json(vehicle.T_map_vehicle.value_or(Pose2{}), vehicle.map_id);
  position["positionInitialized"] = vehicle.T_map_vehicle.has_value();
  position["localizationScore"] = rounded(vehicle.localisation_score, 2);
  return position;
}

Json velocity_json(const VehicleState& vehicle) {
  return {{"vx", rounded(vehicle.speed_mps, 3)}, {"vy", 0}, {"omega", rounded(vehicle.turn_rate_rad_s, 3)}};
}

Json action_catalog_json() {
  Json actions = Json::array();
  for (const CatalogAction& action : kCatalogActions) {
    Json parameters = Json::array();
    for (const CatalogParameter& one : action.parameters) {
      if (one.key.empty()) continue;
      parameters.push_back({{"key", one.key},
                            {"valueDataType", one.type},
                            {"description", one.meaning},
                            {"isOptional", false}});
    }
    actions.push_back({{"actionType", action.type},
                       {"actionDescription", action.meaning},
                       {"actionScopes", Json::array({action.is_instant ? "INSTANT" : "NODE"})},
                       {"actionParameters", std::move(parameters)},
                       {"blockingTypes", Json::array({action.is_instant ? "NONE" : "HARD"})}});
  }
  return actions;
}

}  // namespace

std::string_view name_of(ActionState::Status status) {
  constexpr std::array<std::string_view, 6> kNames = {"WAITING", "INITIALIZING", "RUNNING",
                                                      "PAUSED",  "FINISHED",     "FAILED"};
  return kNames.at(static_cast<std::size_t>(status));
}

std::string state_json(const FleetHeader& header, const OrderState& order, const VehicleState& vehicle) {
  Json json = header_json(header);
  json["orderId"] = order.order_id;
  json["orderUpdateId"] = order.update_id;
  if (!order.zone_set_id.empty()) json["zoneSetId"] = order.zone_set_id;
  json["lastNodeId"] = order.last_node_id;
  json["lastNodeSequenceId"] = order.last_node_sequence;
  json["driving"] = vehicle.is_driving;
  json["paused"] = order.is_paused;
  json["newBaseRequest"] = order.wants_base;
  json["nodeStates"] = Json::array();
  for (const OrderNode& node : order.nodes) json["nodeStates"].push_back(node_json(node, vehicle.map_id));
  json["edgeStates"] = Json::array();
  for (const OrderEdge& edge : order.edges)
    json["edgeStates"].push_back(
        {{"edgeId", edge.id}, {"sequenceId", edge.sequence}, {"released", edge.released}});
  json["agvPosition"] = own_position_json(vehicle);
  json["velocity"] = velocity_json(vehicle);
  json["loads"] = Json::array();
  json["actionStates"] = Json::array();
  for (const ActionState& action : order.actions)
    json["actionStates"].push_back({{"actionId", action.id},
                                    {"actionType", action.type},
                                    {"actionStatus", name_of(action.status)},
                                    {"resultDescription", action.result}});
  json["batteryState"] = {{"batteryCharge", 100}, {"charging", false}};
  json["operatingMode"] = "AUTOMATIC";
  json["errors"] = Json::array();
  for (const FleetError& error : order.errors) json["errors"].push_back(error_json(error));
  json["information"] = Json::array({{{"infoType", "battery"},
                                      {"infoDescription", "the battery is not measured; 100 stands for that"},
                                      {"infoLevel", "DEBUG"}}});
  json["safetyState"] = {{"eStop", "NONE"}, {"fieldViolation", vehicle.is_touching}};
  return text_of(json);
}

std::string visualization_json(const FleetHeader& header, const VehicleState& vehicle) {
  Json json = header_json(header);
  json["agvPosition"] = own_position_json(vehicle);
  json["velocity"] = velocity_json(vehicle);
  return text_of(json);
}

std::string connection_json(const FleetHeader& header, FleetConnection connection) {
  constexpr std::array<const char*, 3> kNames = {"ONLINE", "OFFLINE", "CONNECTIONBROKEN"};
  Json json = header_json(header);
  json["connectionState"] = kNames.at(static_cast<std::size_t>(connection));
  return text_of(json);
}

std::string factsheet_json(const FleetHeader& header, const VehicleDescription& vehicle) {
  Json json = header_json(header);
  json["typeSpecification"] = {{"seriesName", vehicle.name},
                               {"agvKinematic", vehicle.is_differential ? "DIFF" : "THREEWHEEL"},
                               {"agvClass", "CARRIER"},
                               {"maxLoadMass", 0},
                               {"localizationTypes", Json::array({"NATURAL"})},
                               {"navigationTypes", Json::array({"AUTONOMOUS"})}};
  const Footprint& footprint = vehicle.footprint;
  const DriveLimits& limits = vehicle.limits;
  json["physicalParameters"] = {{"speedMin", 0},
                                {"speedMax", limits.speed_max_mps},
                                {"accelerationMax", limits.acceleration_max_mps2},
                                {"decelerationMax", limits.deceleration_max_mps2},
                                {"heightMin", footprint.height_m},
                                {"heightMax", footprint.height_m},
                                {"width", footprint.width_m},
                                {"length", footprint.front_m + footprint.rear_m}};
  json["protocolLimits"] = {{"maxStringLens", {{"msgLen", 1 << 20}, {"idLen", 500}}},
                            {"maxArrayLens", {{"order.nodes", 2000}, {"order.edges", 2000}}},
                            {"timing", {{"minOrderInterval", 0.1}, {"minStateInterval", 0.1}}}};
  json["protocolFeatures"] = {
      {"optionalParameters",
       Json::array({{{"parameter", "order.nodes.nodePosition"}, {"support", "SUPPORTED"}},
                    {{"parameter", "order.edges.maxSpeed"}, {"support", "SUPPORTED"}}})},
      {"agvActions", action_catalog_json()}};
  const double left_m = footprint.width_m / 2;
  const auto corner = [](double x_m, double y_m) { return Json{{"x", x_m}, {"y", y_m}}; };
  Json outline = Json::array({corner(footprint.front_m, left_m), corner(-footprint.rear_m, left_m),
                              corner(-footprint.rear_m, -left_m), corner(footprint.front_m, -left_m)});
  json["agvGeometry"] = {
      {"envelopes2d", Json::array({{{"set", "footprint"}, {"polygonPoints", std::move(outline)}}})}};
  json["loadSpecification"] = Json::object();
  return text_of(json);
}

}  // namespace aisle
