#include "aisle/fleet/order_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "aisle/formats/json_document.hpp"

namespace aisle {
namespace {

using nlohmann::json;

constexpr std::size_t kNodesMax = 2000;
constexpr std::size_t kActionsMax = 1000;
constexpr std::size_t kProblemsMax = 20;
constexpr std::size_t kText_bytes = 500;

/// An object of a message; every access that fails is a problem with the key's path.
class FleetObject {
 public:
  FleetObject(const json& value, std::string path, Problems& problems)
      : value_(value), path_(std::move(path)), problems_(problems) {
    if (!value_.is_object()) refuse("", "is no object");
  }

  std::string text(const char* key, bool is_required = true) const {
    const json* const found = find(key, is_required);
    if (found == nullptr) return {};
    if (!found->is_string()) return refuse(key, "is no text"), std::string();
    const auto& text = found->get_ref<const std::string&>();
    if (text.size() > kText_bytes) return refuse(key, "is longer than 500 bytes"), std::string();
    if (is_required && text.empty()) refuse(key, "is empty");
    return text;
  }

  std::uint32_t count(const char* key) const {
    const json* const found = find(key, true);
    if (found == nullptr) return 0;
    const bool is_count = found->is_number_unsigned() &&
                          found->get<std::uint64_t>() <= std::numeric_limits<std::uint32_t>::max();
    if (!is_count) return refuse(key, "is no whole number from 0 to 4294967295"), 0U;
    return found->get<std::uint32_t>();
  }

  bool flag(const char* key) const {
    const json* const found = find(key, true);
    if (found == nullptr) return false;
    if (!found->is_boolean()) return refuse(key, "is neither true nor false"), false;
    return found->get<bool>();
  }

  /// @param greatest  of its absolute value
  std::optional<double> number(const char* key, double greatest, bool is_required = false) const {
    const json* const found = find(key, is_required);
    if (found == nullptr) return std::nullopt;
    const double value = found->is_number() ? found->get<double>() : std::nan("");
    if (!(std::abs(value) <= greatest))
      return refuse(key, fmt::format("is no number between {} and {}", -greatest, greatest)), std::nullopt;
    return value;
  }

  /// Null: absent, or no object, which is a problem.
  const json* object(const char* key) const {
    const json* const found = find(key, false);
    if (found == nullptr || found->is_object()) return found;
    return refuse(key, "is no object"), nullptr;
  }

  /// The elements of a list; a list that is absent though required, too long or none is a problem, and empty.
  const json& list(const char* key, std::size_t most, bool is_required = true) const {
    static const json none = json::array();
    const json* const found = find(key, is_required);
    if (found == nullptr) return none;
    if (!found->is_array()) return refuse(key, "is no list"), none;
    if (found->size() > most) return refuse(key, fmt::format("has more than {} entries", most)), none;
    return *found;
  }

  std::string path_of(const char* key) const { return path_.empty() ? key : path_ + "." + key; }
  std::string path_of(const char* key, std::size_t i) const { return fmt::format("{}[{}]", path_of(key), i); }

  void refuse(const char* key, const std::string& what) const {
    if (problems_.size() < kProblemsMax)
      problems_.push_back({{"", 0, *key == '\0' ? path_ : path_of(key)}, what});
  }

  Problems& problems() const { return problems_; }

 private:
  const json* find(const char* key, bool is_required) const {
    if (!value_.is_object()) return nullptr;
    const auto found = value_.find(key);
    if (found != value_.end() && !found->is_null()) return &*found;
    if (is_required) refuse(key, "is missing");
    return nullptr;
  }

  const json& value_;
  std::string path_;
  Problems& problems_;
};

FleetAction::Blocking blocking_of(const FleetObject& object) {
  const std::string text = object.text("blockingType");
  if (text == "NONE") return FleetAction::Blocking::kNone;
  if (text == "SOFT") return FleetAction::Blocking::kSoft;
  if (text != "HARD" && !text.empty()) object.refuse("blockingType", "is neither NONE, SOFT nor HARD");
  return FleetAction::Blocking::kHard;
}

FleetAction read_action(const FleetObject& object) {
  FleetAction action;
  action.type = object.text("actionType");
  action.id = object.text("actionId");
  action.blocking = blocking_of(object);
  const json& parameters = object.list("actionParameters", 100, false);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const FleetObject parameter(parameters[i], object.path_of("actionParameters", i), object.problems());
    const std::string key = parameter.text("key");
    if (!parameters[i].is_object()) continue;
    const auto value = parameters[i].find("value");
    if (value == parameters[i].end()) {
      parameter.refuse("value", "is missing");
    } else {
      action.parameters[key] = *value;
    }
  }
  return action;
}

std::vector<FleetAction> read_actions(const FleetObject& object, const char* key, std::set<std::string>& ids,
                                      bool is_required) {
  std::vector<FleetAction> actions;
  const json& list = object.list(key, kActionsMax, is_required);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const FleetObject one(list[i], object.path_of(key, i), object.problems());
    actions.push_back(read_action(one));
    if (!ids.insert(actions.back().id).second) one.refuse("actionId", "names two actions");
    if (ids.size() > kActionsMax) one.refuse("", "is one of more than 1000 actions");
  }
  return actions;
}

void read_position(const FleetObject& object, OrderNode& node) {
  constexpr double kFarthest_m = 1e5;
  const json* const value = object.object("nodePosition");
  if (value == nullptr) return;
  const FleetObject position(*value, object.path_of("nodePosition"), object.problems());
  const auto x = position.number("x", kFarthest_m, true), y = position.number("y", kFarthest_m, true);
  if (x && y) node.p_map = Vec2(*x, *y);
  node.heading_rad = position.number("theta", 2 * kPi);
  node.deviation_m = std::abs(position.number("allowedDeviationXY", kFarthest_m).value_or(0));
  node.deviation_rad = position.number("allowedDeviationTheta", 2 * kPi);
  node.map_id = position.text("mapId", false);
}

OrderNode read_node(const FleetObject& object, std::set<std::string>& action_ids) {
  OrderNode node;
  node.id = object.text("nodeId");
  node.sequence = object.count("sequenceId");
  node.released = object.flag("released");
  read_position(object, node);
  node.actions = read_actions(object, "actions", action_ids, true);
  return node;
}

OrderEdge read_edge(const FleetObject& object, std::set<std::string>& action_ids) {
  OrderEdge edge;
  edge.id = object.text("edgeId");
  edge.sequence = object.count("sequenceId");
  edge.released = object.flag("released");
  edge.from = object.text("startNodeId");
  edge.to = object.text("endNodeId");
  edge.speed_max_mps = object.number("maxSpeed", 100);
  if (edge.speed_max_mps && *edge.speed_max_mps <= 0) object.refuse("maxSpeed", "is not above 0");
  edge.actions = read_actions(object, "actions", action_ids, true);
  return edge;
}

void refuse_at(Problems& problems, const char* list, std::size_t i, const char* key,
               const std::string& what) {
  if (problems.size() < kProblemsMax)
    problems.push_back({{"", 0, fmt::format("{}[{}].{}", list, i, key)}, what});
}

/// Nodes and edges follow each other, and what is released comes first.
void check_sequence(const Order& order, Problems& problems) {
  if (order.nodes.empty()) return problems.push_back({{"", 0, "nodes"}, "is empty"});
  if (order.edges.size() + 1 != order.nodes.size())
    return problems.push_back({{"", 0, "edges"},
                               fmt::format("has {} entries, but {} nodes need {}", order.edges.size(),
                                           order.nodes.size(), order.nodes.size() - 1)});
  const std::uint64_t first = order.nodes.front().sequence;
  if (first % 2 != 0) refuse_at(problems, "nodes", 0, "sequenceId", "is odd; nodes have even ones");
  if (!order.nodes.front().released)
    refuse_at(problems, "nodes", 0, "released", "is false, so there is no base");
  for (std::size_t i = 0; i < order.edges.size(); ++i) {
    const OrderNode &from = order.nodes[i], &to = order.nodes[i + 1];
    const OrderEdge& edge = order.edges[i];
    if (edge.sequence != first + 2 * i + 1)
      refuse_at(problems, "edges", i, "sequenceId", fmt::format("is not {}", first + 2 * i + 1));
    if (to.sequence != first + 2 * i + 2)
      refuse_at(problems, "nodes", i + 1, "sequenceId", fmt::format("is not {}", first + 2 * i + 2));
    if (edge.from != from.id)
      refuse_at(problems, "edges", i, "startNodeId", fmt::format("is not '{}'", from.id));
    if (edge.to != to.id) refuse_at(problems, "edges", i, "endNodeId", fmt::format("is not '{}'", to.id));
    if (edge.released != to.released)
      refuse_at(problems, "edges", i, "released", "is not what its end node says");
    if (to.released && !from.released)
      refuse_at(problems, "nodes", i + 1, "released", "is true behind a node of the horizon");
  }
}

/// The document, and that it is of a version that is understood.
Result<json> read_message(std::string_view text) {
  if (text.size() > kFleetMessage_bytes) return Problem{{}, "is larger than 1 MiB"};
  auto document = parse_json(text, "");
  if (!document) return document.problems();
  if (!document->is_object()) return Problem{{}, "is no object"};
  const auto version = document->find("version");
  const bool is_known = version != document->end() && version->is_string() &&
                        version->get_ref<const std::string&>().starts_with("2.");
  if (!is_known) return Problem{{"", 0, "version"}, "is not 2.x, such as 2.1.0"};
  return document;
}

}  // namespace

Result<Order> read_order(std::string_view text) {
  const auto document = read_message(text);
  if (!document) return document.problems();
  Problems problems;
  const FleetObject object(*document, "", problems);
  Order order;
  order.id = object.text("orderId");
  order.update_id = object.count("orderUpdateId");
  order.zone_set_id = object.text("zoneSetId", false);
  std::set<std::string> action_ids;
  const json& nodes = object.list("nodes", kNodesMax);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    order.nodes.push_back(read_node({nodes[i], object.path_of("nodes", i), problems}, action_ids));
  const json& edges = object.list("edges", kNodesMax);
  for (std::size_t i = 0; i < edges.size(); ++i)
    order.edges.push_back(read_edge({edges[i], object.path_of("edges", i), problems}, action_ids));
  if (problems.empty()) check_sequence(order, problems);
  if (!problems.empty()) return problems;
  return order;
}

Result<std::vector<FleetAction>> read_instant_actions(std::string_view text) {
  const auto document = read_message(text);
  if (!document) return document.problems();
  Problems problems;
  std::set<std::string> ids;
  // Version 1 named the list as the topic; some masters still do.
  const char* const key = document->contains("actions") ? "actions" : "instantActions";
  auto actions = read_actions(FleetObject(*document, "", problems), key, ids, true);
  if (!problems.empty()) return problems;
  return actions;
}

}  // namespace aisle
