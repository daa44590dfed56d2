#pragma once
/// A building's corridors as master controls know them: named nodes and straight edges between them.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "aisle/maps/building.hpp"

namespace aisle {

struct FleetNode {
  std::string id;
  Vec2 p_map;
};

/// Driven from one node to the other, in this direction.
struct FleetEdge {
  std::string id;
  std::size_t from = 0, to = 0;  ///< nodes
};

struct FleetStation {
  std::string name;
  std::size_t node = 0;  ///< where a vehicle stands at it
  Vec2 p_map = Vec2::Zero();
  std::optional<double> heading_rad;  ///< nullopt: any
};

struct FleetGraph {
  std::vector<FleetNode> nodes;
  std::vector<FleetEdge> edges;
  std::vector<FleetStation> stations;

  /// nullopt: there is no such node.
  std::optional<Vec2> find(const std::string& node_id) const;
};

/// How far apart nodes are at most, unless told otherwise: vehicles share a corridor by its edges.
inline constexpr double kFleetSpacing_m = 4;

/// The corridors' nodes under their own names ("crossing 2"), between them nodes wherever a corridor bends or
/// goes on for more than `spacing_m` ("corridor 3.1"), and the places, each joined to the nearest of those if
/// nothing stands between. What lies in a keep-out zone is left out, as are edges against a one-way zone.
FleetGraph fleet_graph(const Building& building, double spacing_m = kFleetSpacing_m);

/// The graph in the Layout Interchange Format (LIF) 1.0.0 of VDMA.
/// @param timestamp  ISO 8601, UTC
std::string lif_json(const FleetGraph& graph, const Building& building, const std::string& timestamp);

}  // namespace aisle
