#include "recording.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cstddef>

#include "aisle/commands/packed_recording.hpp"
#include "aisle/formats/logs/read_laser_recording.hpp"
#include "aisle/learning/walls/scan_odometry.hpp"
#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"

namespace aisle::python {
namespace {

/// One scan of a recording.
struct RecordedScan {
  std::shared_ptr<const LaserLog> log;
  std::size_t index = 0;

  const LaserScan& scan() const { return log->scans[index]; }
  LaserScanner laser() const { return log->laser_of(scan()); }
};

Recording read_recording(const std::filesystem::path& path, const std::string& units,
                         const py::object& laser_offset, const std::string& scan_topic,
                         const std::string& odometry, const py::object& progress) {
  const RecordingOptions options = reading_of(units, laser_offset, scan_topic, odometry);
  PythonConsole console(progress);
  auto read = without_lock([&] {
    return with_unpacked(path, *console, [&](const std::filesystem::path& unpacked, Console&) {
      return read_laser_recording(unpacked, options);
    });
  });
  LaserRecording recording = value_or_raise(std::move(read), path);
  return {std::make_shared<const LaserLog>(std::move(recording.log)), std::move(recording.warnings)};
}

RecordedScan scan_at(const Recording& recording, py::ssize_t index) {
  const auto count = static_cast<py::ssize_t>(recording.log->scans.size());
  if (index < -count || index >= count) throw py::index_error("no such scan");
  return {recording.log, static_cast<std::size_t>(index < 0 ? index + count : index)};
}

py::array ranges_of_all(const Recording& recording) {
  const std::vector<LaserScan>& scans = recording.log->scans;
  std::size_t beams = 0;
  for (const LaserScan& scan : scans) beams = std::max(beams, scan.ranges_m.size());
  std::vector<float> ranges_m(scans.size() * beams);
  for (std::size_t i = 0; i < scans.size(); ++i)
    std::copy(scans[i].ranges_m.begin(), scans[i].ranges_m.end(),
              ranges_m.begin() + static_cast<std::ptrdiff_t>(i * beams));
  return moved_to_array(std::move(ranges_m), {py::ssize_t(scans.size()), py::ssize_t(beams)});
}

py::array angles_of(const RecordedScan& recorded) {
  const LaserScanner laser = recorded.laser();
  std::vector<double> angles_rad(recorded.scan().ranges_m.size());
  for (std::size_t beam = 0; beam < angles_rad.size(); ++beam) angles_rad[beam] = laser.beam_angle(beam);
  const auto beams = static_cast<py::ssize_t>(angles_rad.size());
  return moved_to_array(std::move(angles_rad), {beams});
}

py::array points_of_scan(const RecordedScan& recorded) {
  std::vector<Vec2> points;
  points_of(recorded.laser(), recorded.scan().ranges_m, points);
  return array_of(points);
}

void bind_scan(py::module_& module) {
  py::class_<LaserScanner>(module, "LaserScanner",
                           "How a 2-D scanner sits on its vehicle and what its readings mean.")
      .def_readonly("first_angle_rad", &LaserScanner::first_angle_rad,
                    "Beam 0 in the laser's frame: 0 is straight ahead, left positive.")
      .def_readonly("angle_step_rad", &LaserScanner::angle_step_rad,
                    "From one beam to the next, counter-clockwise.")
      .def_readonly("range_max_m", &LaserScanner::range_max_m,
                    "A reading of this or more means: nothing seen.")
      .def_property_readonly(
          "T_vehicle_laser", [](const LaserScanner& laser) { return array_of(laser.T_vehicle_laser); },
          "(3,): x_m, y_m, heading_rad of the laser in the vehicle's frame (x ahead, y left).");

  py::class_<RecordedScan>(module, "Scan", "One scan of a recording.")
      .def_property_readonly(
          "stamp_s", [](const RecordedScan& scan) { return scan.scan().stamp_s; }, "As recorded [s].")
      .def_property_readonly(
          "time_s", [](const RecordedScan& scan) { return scan.scan().time_s; },
          "Of the middle beam [s], on a clock that never goes back.")
      .def_property_readonly(
          "ranges_m",
          [](const py::object& self) {
            const auto& ranges_m = self.cast<const RecordedScan&>().scan().ranges_m;
            return view_of(ranges_m.data(), {py::ssize_t(ranges_m.size())}, {py::ssize_t(sizeof(float))},
                           self);
          },
          "(beams,) float32, read-only, not copied: 0 is nothing usable, laser.range_max_m or more nothing "
          "seen.")
      .def_property_readonly("angles_rad", angles_of,
                             "(beams,): of each beam in the laser's frame, left positive.")
      .def_property_readonly("laser", &RecordedScan::laser,
                             "The scanner that took it, with this scan's beams.")
      .def("points_m", points_of_scan,
           "(points, 2): x, y of what was hit up to 20 m away, in the laser's frame, in the order of the "
           "beams.");
}

}  // namespace

RecordingOptions reading_of(const std::string& units, const py::object& laser_offset,
                            const std::string& scan_topic, const std::string& odometry) {
  RecordingOptions options{.scan_topic = scan_topic, .odometry = odometry};
  if (units == "cm") {
    options.unit = LengthUnit::kCentimetre;
  } else if (units == "mm") {
    options.unit = LengthUnit::kMillimetre;
  } else if (units != "m") {
    raise_problems({{{"units"}, "is '" + units + "', not m, cm or mm"}});
  }
  if (!laser_offset.is_none()) options.T_vehicle_laser = pose_of(laser_offset, "laser_offset");
  return options;
}

void bind_recordings(py::module_& module) {
  bind_scan(module);
  py::class_<Recording>(
      module, "Recording",
      "What a vehicle with a laser scanner recorded: a sequence of scans, and the odometry.\n\n"
      "Arrays are read-only views unless they say that they copy.")
      .def("__len__", [](const Recording& recording) { return recording.log->scans.size(); })
      .def("__getitem__", scan_at, py::arg("index"))
      .def_property_readonly(
          "stamps_s",
          [](const py::object& self) {
            return column_of(self.cast<const Recording&>().log->scans, &LaserScan::stamp_s, self);
          },
          "(scans,): as recorded [s].")
      .def_property_readonly(
          "times_s",
          [](const py::object& self) {
            return column_of(self.cast<const Recording&>().log->scans, &LaserScan::time_s, self);
          },
          "(scans,): of the middle beams [s], on a clock that never goes back.")
      .def_property_readonly(
          "odometry",
          [](const py::object& self) {
            return columns_of<double>(self.cast<const Recording&>().log->odometry, &OdometrySample::time_s, 4,
                                      self);
          },
          "(samples, 4): time_s on the scans' clock, x_m, y_m, heading_rad of the vehicle in `odom`.")
      .def_property_readonly(
          "lasers", [](const Recording& recording) { return recording.log->lasers; },
          "[LaserScanner]: at least one.")
      .def_property_readonly(
          "warnings", [](const Recording& recording) { return list_of(recording.warnings); },
          "[Problem]: what was guessed or left out.")
      .def("ranges_m", ranges_of_all,
           "(scans, beams) float32, a copy: 0 is nothing usable, also where a scan has fewer beams than "
           "another.");
  static_assert(offsetof(OdometrySample, T_odom_vehicle) == sizeof(double) &&
                sizeof(Pose2) == 3 * sizeof(double));

  module.def(
      "read_recording", read_recording, py::arg("path"), py::kw_only(), py::arg("units") = "m",
      py::arg("laser_offset") = py::none(), py::arg("scan_topic") = "", py::arg("odometry") = "",
      py::arg("progress") = py::none(),
      "Reads a recording of a 2-D scanner as it is: CARMEN log, MRPT rawlog, CSV, ROS bag, also in an "
      "archive.\n\n"
      "units: of the lengths in a text: m, cm or mm.\n"
      "laser_offset: (x_m, y_m, heading_rad) of the laser on the vehicle, instead of the recording's.\n"
      "scan_topic, odometry: of a bag; odometry may also be 'tf' or 'none'.\n"
      "progress: called as progress(task, done, total); total is 0 where it is not known.\n"
      "Raises OSError if there is no such file, InputError if it is no such recording.");
}

}  // namespace aisle::python
