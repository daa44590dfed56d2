#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>

#include "aisle/commands/map.hpp"
#include "aisle/report/occupancy.hpp"
#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"
#include "recording.hpp"

namespace aisle::python {
namespace {

RecordingMap map_log(const std::filesystem::path& path, const py::object& parameters,
                     const std::string& units, const py::object& laser_offset, const std::string& scan_topic,
                     const std::string& odometry, std::optional<double> odometry_delay_s,
                     const py::object& progress) {
  MapOptions options{.log = path,
                     .reading = reading_of(units, laser_offset, scan_topic, odometry),
                     .odometry_delay_s = odometry_delay_s};
  params_from<MapParams>(parameters);  // names the keys as Python's user does
  for (const auto& [key, value] : parameter_texts(parameters))
    options.parameters.settings.push_back(key + "=" + value);
  PythonConsole console(progress);
  return value_or_raise(without_lock([&] { return map_recording(options, *console); }), path);
}

py::array trajectory_of(const RecordingMap& map) {
  py::array_t<double> trajectory({py::ssize_t(map.log.scans.size()), py::ssize_t(4)});
  double* number = trajectory.mutable_data();
  for (std::size_t i = 0; i < map.log.scans.size(); ++i) {
    const Pose2& pose = map.result.T_map_vehicle[i];
    for (const double value : {map.log.scans[i].stamp_s, pose.x, pose.y, pose.theta}) *number++ = value;
  }
  return trajectory;
}

OccupancyImage grid_of(const RecordingMap& map) {
  return without_lock([&] {
    return occupancy_of(map.result.walls, *building_of(map).floor, map.log, map.result.T_map_vehicle);
  });
}

Recording recording_of(const std::shared_ptr<RecordingMap>& map) {
  return {std::shared_ptr<const LaserLog>(map, &map->log), map->warnings};
}

}  // namespace

void bind_mapping(py::module_& module) {
  py::class_<RecordingMap, std::shared_ptr<RecordingMap>>(
      module, "RecordingMap",
      "The map of a recording, in the frame `map`, where the vehicle drove through it, and how far to trust "
      "it.")
      .def_readonly("name", &RecordingMap::name, "Of the recording.")
      .def_property_readonly(
          "trajectory", trajectory_of,
          "(scans, 4), a copy: stamp_s, x_m, y_m, heading_rad of the vehicle at every scan.")
      .def_property_readonly(
          "poses",
          [](const py::object& self) {
            return rows_of<double>(self.cast<const RecordingMap&>().result.T_map_vehicle, self);
          },
          "(scans, 3), a view: the trajectory without its stamps.")
      .def_property_readonly(
          "walls",
          [](const py::object& self) {
            return columns_of<double>(self.cast<const RecordingMap&>().result.walls.walls, &Wall::segment, 4,
                                      self);
          },
          "(walls, 4), a view: start x, y and end x, y [m]; the side that it was seen from is on its LEFT.")
      .def_property_readonly(
          "loop_closures",
          [](const py::object& self) {
            return rows_of<std::uint64_t>(self.cast<const RecordingMap&>().result.loop_closures, self);
          },
          "(loops, 2), a view: scans that show the same place, the older one first.")
      .def("grid", grid_of,
           "Grid: free where beams passed, occupied along the walls. Made when it is asked for.")
      .def("building", building_of, "Building with these walls; its write() makes a building file.")
      .def_property_readonly("recording", recording_of,
                             "Recording as it was mapped: its scans, its odometry.")
      .def_property_readonly(
          "trust", [](const RecordingMap& map) { return name_of(trust_in(map.judgement)); },
          "good, doubtful, poor or unknown: how far the map can be trusted.")
      .def_property_readonly(
          "trust_reason", [](const RecordingMap& map) { return reason_of(map.judgement); },
          "Why, as a sentence.")
      .def_property_readonly(
          "fit_share", [](const RecordingMap& map) { return map.judgement.fit_share; },
          "Share of the readings that end on a wall of the map.")
      .def_property_readonly(
          "pass_share", [](const RecordingMap& map) { return map.judgement.pass_share; },
          "Share of the readings that would have to pass through a wall.")
      .def_property_readonly(
          "path_m", [](const RecordingMap& map) { return map.result.path_m; }, "Length of the path.")
      .def_property_readonly(
          "odometry_delay_s", [](const RecordingMap& map) { return map.result.odometry_delay_s; },
          "How much later than a scan the odometry recorded with it was taken.")
      .def_property_readonly(
          "has_dominant_direction", [](const RecordingMap& map) { return map.result.has_dominant_direction; },
          "Most walls lie on one orthogonal frame, the axes of `map`.")
      .def_property_readonly(
          "warnings", [](const RecordingMap& map) { return list_of(map.warnings); },
          "[Problem]: what was guessed, left out or not believed.");
  static_assert(sizeof(std::size_t) == sizeof(std::uint64_t));

  module.def(
      "map_recording", map_log, py::arg("path"), py::kw_only(), py::arg("parameters") = py::none(),
      py::arg("units") = "m", py::arg("laser_offset") = py::none(), py::arg("scan_topic") = "",
      py::arg("odometry") = "", py::arg("odometry_delay_s") = py::none(), py::arg("progress") = py::none(),
      "Maps a recording of a 2-D scanner, with the numbers of `aisle map`: nothing has to be tuned.\n\n"
      "parameters: {key: value} of `aisle map --print-params`, such as {'loops.submap_m': 4}.\n"
      "odometry_delay_s: of the odometry behind its scan; None: estimated from the recording.\n"
      "The others are those of read_recording.\n"
      "Other threads run meanwhile; Ctrl-C ends it. Raises OSError, or InputError with every problem.");
}

}  // namespace aisle::python
