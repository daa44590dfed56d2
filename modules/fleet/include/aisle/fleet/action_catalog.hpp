#pragma once

#include <array>
#include <string_view>

namespace aisle {

struct CatalogParameter {
  std::string_view key, type, meaning;
};

struct CatalogAction {
  std::string_view type;
  bool is_instant = true;  ///< else of a node
  std::string_view meaning;
  std::array<CatalogParameter, 5> parameters = {};  ///< empty keys: none
};

/// The one action of nodes.
inline constexpr std::string_view kWaitAction = "wait";

/// Every action that aisle knows.
inline constexpr std::array<CatalogAction, 7> kCatalogActions = {{
    {"startPause", true, "stops, and stays until stopPause", {}},
    {"stopPause", true, "goes on", {}},
    {"cancelOrder", true, "stops at once and drops the order", {}},
    {"stateRequest", true, "sends the state", {}},
    {"factsheetRequest", true, "sends the factsheet", {}},
    {"initPosition",
     true,
     "looks whether it stands there",
     {{{"x", "FLOAT", "in the map, in metres"},
       {"y", "FLOAT", "in the map, in metres"},
       {"theta", "FLOAT", "heading in radians"},
       {"mapId", "STRING", "name of the building"},
       {"lastNodeId", "STRING", "node on which it stands"}}}},
    {kWaitAction, false, "stands at the node", {{{"duration", "FLOAT", "in seconds, at most 86400"}}}},
}};

/// Null: unknown.
constexpr const CatalogAction* catalog_action(std::string_view type, bool is_instant) {
  for (const CatalogAction& action : kCatalogActions) {
    if (action.type == type && action.is_instant == is_instant) return &action;
  }
  return nullptr;
}

}  // namespace aisle
