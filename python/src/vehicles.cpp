#include <fmt/format.h>
#include <pybind11/stl.h>

#include <array>
#include <memory>
#include <utility>

#include "aisle/guidance/navigator.hpp"
#include "aisle/vehicle/odometry_step.hpp"
#include "arrays.hpp"
#include "bindings.hpp"

namespace aisle::python {
namespace {

constexpr std::array<std::pair<NavigatorStatus, const char*>, 3> kStatusNames = {{
    {NavigatorStatus::kGoing, "going"},
    {NavigatorStatus::kDone, "done"},
    {NavigatorStatus::kFailed, "failed"},
}};

const char* name_of(NavigatorStatus status) {
  for (const auto& [known, name] : kStatusNames)
    if (known == status) return name;
  throw py::value_error("no such status");
}

NavigatorStatus status_named(const std::string& text) {
  for (const auto& [known, name] : kStatusNames)
    if (name == text) return known;
  throw py::value_error(fmt::format("status: is '{}', not going, done or failed", text));
}

Command make_command(double speed_mps, double steering_rad, double turn_rate_rad_s) {
  return {speed_mps, steering_rad, turn_rate_rad_s};
}

Decision make_decision(const Command& command, const std::string& status, const std::string& state,
                       const std::string& why) {
  return {command, status_named(status), state, why};
}

py::object ranges_of(const py::object& self) {
  const auto& observation = self.cast<const Observation&>();
  if (!observation.scan) return py::none();
  const std::vector<float>& ranges_m = observation.scan->ranges_m;
  return view_of(ranges_m.data(), {py::ssize_t(ranges_m.size())}, {py::ssize_t(sizeof(float))}, self);
}

py::dict images_of(const Observation& observation) {
  py::dict images;
  for (const CameraImage& image : observation.images) images[py::str(image.camera)] = array_of(image.pixels);
  return images;
}

py::dict image_stamps_of(const Observation& observation) {
  py::dict stamps_s;
  for (const CameraImage& image : observation.images) stamps_s[py::str(image.camera)] = image.stamp_s;
  return stamps_s;
}

py::tuple odometry_of(const Observation& observation) {
  if (const auto* motion = std::get_if<FrontSteeredMotion>(&observation.odometry))
    return py::make_tuple(motion->distance_m, motion->steering_rad);
  const auto& steps = std::get<WheelSteps>(observation.odometry);
  return py::make_tuple(steps.left, steps.right);
}

void bind_description(py::module_& module) {
  py::class_<Footprint>(module, "Footprint", "A rectangle about base_link [m].")
      .def_readonly("front_m", &Footprint::front_m, "Ahead of base_link.")
      .def_readonly("rear_m", &Footprint::rear_m, "Behind it.")
      .def_readonly("width_m", &Footprint::width_m, "Left and right together.");
  py::class_<VehicleDescription, std::shared_ptr<VehicleDescription>>(
      module, "Vehicle", "What a vehicle is: how it moves, and what sensors it has.")
      .def_readonly("name", &VehicleDescription::name)
      .def_readonly("is_differential", &VehicleDescription::is_differential,
                    "Two driven wheels; else steered by its front wheels.")
      .def_property_readonly(
          "wheelbase_m", [](const VehicleDescription& vehicle) { return vehicle.front_steered.wheelbase_m; },
          "Of a front-steered vehicle.")
      .def_readonly("footprint", &VehicleDescription::footprint)
      .def_property_readonly("speed_max_mps",
                             [](const VehicleDescription& vehicle) { return vehicle.limits.speed_max_mps; })
      .def_property_readonly(
          "reverse_speed_max_mps",
          [](const VehicleDescription& vehicle) { return vehicle.limits.reverse_speed_max_mps; })
      .def_property_readonly(
          "steering_max_rad",
          [](const VehicleDescription& vehicle) { return vehicle.limits.steering_max_rad; },
          "Of a front-steered vehicle.")
      .def_property_readonly(
          "turn_rate_max_rad_s",
          [](const VehicleDescription& vehicle) { return vehicle.limits.turn_rate_max_rad_s; },
          "Of a differential vehicle.")
      .def_readonly("cycle_s", &VehicleDescription::cycle_s, "From one observation to the next.")
      .def_readonly("scanner", &VehicleDescription::scanner, "LaserScanner, or None.")
      .def_property_readonly(
          "cameras",
          [](const VehicleDescription& vehicle) {
            py::dict sizes;
            for (const CameraDescription& camera : vehicle.cameras)
              sizes[py::str(camera.name)] = py::make_tuple(camera.height_px, camera.width_px);
            return sizes;
          },
          "{name: (height, width)} of its cameras' images [px].")
      .def(
          "motion",
          [](const VehicleDescription& vehicle, const Observation& observation) {
            return array_of(odometry_step(vehicle, observation.odometry));
          },
          py::arg("observation"),
          "(3,): x_m, y_m, heading_rad of base_link now, seen from where it was one observation before, by "
          "the wheels.");
}

void bind_command(py::module_& module) {
  py::class_<Command>(
      module, "Command",
      "How to drive until the next command. The vehicle keeps its own limits, and stops when no command "
      "comes.")
      .def(py::init(&make_command), py::kw_only(), py::arg("speed_mps") = 0.0, py::arg("steering_rad") = 0.0,
           py::arg("turn_rate_rad_s") = 0.0)
      .def_readonly(
          "speed_mps", &Command::speed_mps,
          "Of the front reference point (front-steered) or of base_link (differential); negative: reverse.")
      .def_readonly("steering_rad", &Command::steering_rad, "Front-steered only: left positive.")
      .def_readonly("turn_rate_rad_s", &Command::turn_rate_rad_s, "Differential only: left positive.")
      .def("__eq__", [](const Command& a, const Command& b) { return a == b; })
      .def("__repr__", [](const Command& command) {
        return fmt::format("Command(speed_mps={:g}, steering_rad={:g}, turn_rate_rad_s={:g})",
                           command.speed_mps, command.steering_rad, command.turn_rate_rad_s);
      });
  py::class_<Decision>(module, "Decision",
                       "A navigator's answer: a command, and whether the mission goes on.")
      .def(py::init(&make_decision), py::arg("command") = Command{}, py::kw_only(),
           py::arg("status") = "going", py::arg("state") = "", py::arg("why") = "")
      .def_readonly("command", &Decision::command)
      .def_property_readonly(
          "status", [](const Decision& decision) { return name_of(decision.status); },
          "going, done or failed.")
      .def_readonly("state", &Decision::state, "A word that the navigator defines: 'following', 'lost'.")
      .def_readonly("why", &Decision::why, "One line for people; may be empty.");
}

}  // namespace

void bind_vehicles(py::module_& module) {
  bind_command(module);
  py::class_<Observation, std::shared_ptr<Observation>>(
      module, "Observation", "What a vehicle reports in one cycle. Its arrays are read-only and not copied.")
      .def_readonly("stamp_s", &Observation::stamp_s, "End of the cycle; strictly increasing.")
      .def_property_readonly(
          "ranges_m", ranges_of,
          "(beams,) float32 of the scanner, whose beams Vehicle.scanner describes; 0 is nothing usable, "
          "range_max_m or more nothing seen. None: no scan in this cycle.")
      .def_property_readonly(
          "images", images_of,
          "{camera: (height, width) or (height, width, 3) uint8}; a camera without a new image is absent.")
      .def_property_readonly("image_stamps_s", image_stamps_of, "{camera: middle of the exposure}.")
      .def_property_readonly(
          "odometry", odometry_of,
          "Since the last observation: (distance_m, steering_rad) of a front-steered vehicle, "
          "(left, right) motor steps of a differential one. Vehicle.motion makes a pose of it.")
      .def_readonly("bumper_pressed", &Observation::bumper_pressed,
                    "The vehicle touches something and has stopped by itself.");
  bind_description(module);
}

}  // namespace aisle::python
