#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>

#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/formats/whole_file.hpp"
#include "aisle/maps/building.hpp"
#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"
#include "grid.hpp"

namespace aisle::python {
namespace {

py::dict places_of(const Building& building) {
  py::dict places;
  for (const auto& [name, T, has_heading] : building.places)
    places[py::str(name)] =
        py::make_tuple(T.x, T.y, has_heading ? py::object(py::float_(T.theta)) : py::none());
  return places;
}

/// Where its lines and arcs begin, and where the last one ends.
py::array corners_of(const Path& path) {
  py::array_t<double> corners({py::ssize_t(path.pieces().size()) + (path.empty() ? 0 : 1), py::ssize_t(3)});
  auto* row = static_cast<Pose2*>(static_cast<void*>(corners.mutable_data()));
  for (const PathPiece& piece : path.pieces()) *row++ = piece.T_map_start;
  if (!path.empty()) *row = path.end();
  return corners;
}

py::dict routes_of(const Building& building) {
  py::dict routes;
  for (const Route& route : building.routes) routes[py::str(route.name)] = corners_of(route.path);
  return routes;
}

py::dict nodes_of(const Building& building) {
  const CorridorGraph& graph = building.corridors;
  py::dict nodes;
  for (std::size_t node = 0; node < graph.nodes.size(); ++node)
    nodes[py::str(graph.name_of(node))] = array_of(graph.nodes[node].p_map);
  return nodes;
}

py::list corridors_of(const Building& building) {
  const CorridorGraph& graph = building.corridors;
  py::list corridors;
  for (const Corridor& corridor : graph.corridors) {
    corridors.append(py::make_tuple(graph.name_of(corridor.from), graph.name_of(corridor.to),
                                    array_of(corridor.path), corridor.width_m));
  }
  return corridors;
}

const char* name_of(Zone::Kind kind) {
  switch (kind) {
    case Zone::Kind::kSlow:
      return "slow";
    case Zone::Kind::kOneWay:
      return "one_way";
    case Zone::Kind::kKeepOut:
      break;
  }
  return "keep_out";
}

std::optional<OccupancyImage> floor_of(const Building& building) {
  return building.floor ? std::optional(image_of(*building.floor)) : std::nullopt;
}

Building read(const std::filesystem::path& path) {
  return value_or_raise(without_lock([&] { return read_building(path); }), path);
}

void write(const Building& building, const std::filesystem::path& path, bool force) {
  std::error_code none;
  if (!force && std::filesystem::exists(path, none))
    raise_problems({{{path.string()}, "exists already; force=True replaces it"}});
  const Problems problems = without_lock([&] { return write_whole_file(path, building_json(building)); });
  if (!problems.empty()) raise_problems(problems, path);
}

void bind_zone(py::module_& module) {
  py::class_<Zone>(module, "Zone", "A part of the floor in which a vehicle drives otherwise than elsewhere.")
      .def_property_readonly(
          "kind", [](const Zone& zone) { return name_of(zone.kind); }, "keep_out, slow or one_way.")
      .def_readonly("name", &Zone::name, "May be empty.")
      .def_property_readonly(
          "outline_m", [](const Zone& zone) { return array_of(zone.outline); },
          "(corners, 2) in `map`; the last is joined to the first.")
      .def_readonly("speed_max_mps", &Zone::speed_max_mps, "Of a slow zone.")
      .def_readonly("direction_rad", &Zone::direction_rad, "Of a one-way zone: a heading in `map`.");
}

}  // namespace

void bind_buildings(py::module_& module) {
  bind_grid(module);
  bind_zone(module);
  py::class_<Building>(
      module, "Building",
      "Everything that was learned of one building, in the frame `map` (x, y on the floor).\n\n"
      "Arrays of walls and landmarks are read-only views, the others copies. Any part may be empty.")
      .def_readonly("name", &Building::name)
      .def_readonly("has_dominant_direction", &Building::has_dominant_direction,
                    "Most walls lie on one orthogonal frame, the axes of `map`.")
      .def_property_readonly(
          "walls",
          [](const py::object& self) {
            return columns_of<double>(self.cast<const Building&>().walls.walls, &Wall::segment, 4, self);
          },
          "(walls, 4): start x, y and end x, y [m]; the side that it was seen from is on its LEFT.")
      .def_property_readonly(
          "wall_sightings",
          [](const py::object& self) {
            return column_of(self.cast<const Building&>().walls.walls, &Wall::sightings, self);
          },
          "(walls,) int32: on how many half metres of the path each was seen.")
      .def_property_readonly(
          "wall_sigmas_m",
          [](const py::object& self) {
            return column_of(self.cast<const Building&>().walls.walls, &Wall::sigma_m, self);
          },
          "(walls,): standard deviation across each.")
      .def_property_readonly(
          "landmarks",
          [](const py::object& self) {
            return columns_of<double>(self.cast<const Building&>().landmarks.all(), &Landmark::p_map, 2,
                                      self);
          },
          "(landmarks, 2): x, y of the floor points of vertical lines [m].")
      .def_property_readonly(
          "landmark_weights",
          [](const py::object& self) {
            return column_of(self.cast<const Building&>().landmarks.all(), &Landmark::weight, self);
          },
          "(landmarks,): confidence; 1 is the mean.")
      .def_property_readonly("places", places_of,
                             "{name: (x_m, y_m, heading_rad)}; heading_rad is None: any heading.")
      .def_property_readonly(
          "routes", routes_of,
          "{name: (poses, 3) x_m, y_m, heading_rad} where the lines and arcs of a taught path meet.")
      .def_property_readonly("nodes", nodes_of, "{name: (2,) x, y [m]}: crossings and ends of corridors.")
      .def_property_readonly(
          "corridors", corridors_of,
          "[(node, node, (points, 2) centre line [m], width_m)] between the nodes of these names.")
      .def_property_readonly("floor", floor_of, "Grid of what was seen at the scanner's height, or None.")
      .def_readonly("zones", &Building::zones, "[Zone]")
      .def("write", write, py::arg("path"), py::kw_only(), py::arg("force") = false,
           "Writes the building file, all or nothing. force: replace a file that is there.");
  static_assert(sizeof(Segment2) == 4 * sizeof(double));

  module.def("read_building", read, py::arg("path"),
             "Reads a building file, plain or gzip. Raises OSError or InputError.");
}

}  // namespace aisle::python
