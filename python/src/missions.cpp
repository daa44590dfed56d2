#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>
#include <utility>

#include "aisle/commands/driven_vehicle.hpp"
#include "aisle/guidance/navigator.hpp"
#include "aisle/missions/mission_recorder.hpp"
#include "aisle/missions/mission_result.hpp"
#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"

namespace aisle::python {
namespace {

constexpr const char* kNavigatorName = "python";

/// A navigator that is an object of Python with `step(observation)`.
class PythonNavigator final : public Navigator {
 public:
  PythonNavigator(const py::object& navigator, std::optional<double> duration_max_s)
      : step_(navigator.attr("step")), duration_max_s_(duration_max_s) {}

  /// Without the interpreter's lock.
  Decision step(const Observation& observation) override {
    if (!start_s_) start_s_ = observation.stamp_s;
    if (duration_max_s_ && observation.stamp_s - *start_s_ >= *duration_max_s_)
      return {.status = NavigatorStatus::kFailed,
              .state = "time-out",
              .why = fmt::format("was not done after {:g} s", *duration_max_s_)};
    const py::gil_scoped_acquire lock;
    const py::object answer = step_(std::make_shared<Observation>(observation));
    if (py::isinstance<Command>(answer)) return {.command = answer.cast<Command>(), .state = "driving"};
    if (py::isinstance<Decision>(answer)) return answer.cast<Decision>();
    throw py::type_error("step() returned " + py::repr(answer.get_type()).cast<std::string>() +
                         ", not an aisle.Command or an aisle.Decision");
  }

 private:
  py::object step_;
  std::optional<double> duration_max_s_;
  std::optional<double> start_s_;
};

/// How a mission of Python is driven and recorded.
struct MissionKeywords {
  VehicleChoice choice;
  DrivenBy sensors = DrivenBy::kScanner;
  std::optional<Pose2> T_world_start;
  bool takes_images = true;
  std::filesystem::path out;
  bool force = false;
};

Result<std::unique_ptr<DrivenVehicle>> vehicle_for(const MissionKeywords& mission, Console& console) {
  auto driven = DrivenVehicle::open(mission.choice, mission.sensors, console);
  if (!driven || (*driven)->setting() == nullptr) return driven;
  const SimulationSetting& setting = *(*driven)->setting();
  const auto start = mission.T_world_start ? Result<Pose2>(*mission.T_world_start) : start_in(setting);
  if (!start) return start.problems();
  if (!fits(setting.world, setting.vehicle.description.footprint, *start))
    return Problem{{setting.world_file.string(), 0, "start"}, "the vehicle does not fit there"};
  (*driven)->set_down(*start, nullptr, mission.takes_images);
  return driven;
}

Result<MissionResult> run(const MissionKeywords& mission, Navigator& navigator, Console& console) {
  auto driven = vehicle_for(mission, console);
  if (!driven) return driven.problems();
  Vehicle& vehicle = (*driven)->vehicle();
  const TruthSource* const truth = (*driven)->truth();
  const SessionOrigin origin{.navigator = kNavigatorName, .seed = mission.choice.seed};
  auto session = open_session(mission.out, mission.force, SessionStorage::kSqlite, vehicle, truth, origin,
                              (*driven)->watcher(console));
  if (!session) return session.problems();
  MissionRecorder record(*session, vehicle, truth);
  MissionResult result;
  if (Problems problems = drive_mission(vehicle, truth, navigator, record, console.progress, result);
      !problems.empty())
    return problems;
  if (Problems problems = close_session(*session); !problems.empty()) return problems;
  return result;
}

DrivenBy sensors_named(const std::string& sensors) {
  if (sensors == "scanner") return DrivenBy::kScanner;
  if (sensors == "cameras") return DrivenBy::kCameras;
  raise_problems({{{"sensors"}, "is '" + sensors + "', not scanner or cameras"}});
}

MissionResult drive(const py::object& navigator, const std::string& world, const std::string& vehicle,
                    const std::string& scenario, std::uint64_t seed, const py::object& start,
                    bool takes_images, const std::optional<std::filesystem::path>& connect,
                    const std::string& sensors, const std::optional<std::filesystem::path>& out, bool force,
                    std::optional<double> duration_max_s, const py::object& progress) {
  if (connect.has_value() != world.empty())
    raise_problems({{{"world"}, "name a world to simulate, or in `connect` a robot's connection file"}});
  MissionKeywords mission{.choice = {.connection = connect.value_or(""),
                                     .world = world,
                                     .vehicle = vehicle,
                                     .scenario = scenario,
                                     .seed = seed},
                          .sensors = sensors_named(sensors),
                          .takes_images = takes_images,
                          .out = out.value_or(""),
                          .force = force};
  if (!start.is_none()) mission.T_world_start = pose_of(start, "start");
  PythonNavigator deciding(navigator, duration_max_s);
  PythonConsole console(progress);
  return value_or_raise(without_lock([&] { return run(mission, deciding, *console); }),
                        mission.choice.connection);
}

}  // namespace

void bind_missions(py::module_& module) {
  py::class_<MissionResult>(module, "MissionResult", "How a mission ended.")
      .def_property_readonly(
          "arrived", [](const MissionResult& result) { return result.end.arrived; },
          "The navigator was done.")
      .def_property_readonly(
          "state", [](const MissionResult& result) { return result.end.state; }, "Of the last decision.")
      .def_property_readonly(
          "why", [](const MissionResult& result) { return result.end.why; },
          "Of the last decision, or of the vehicle if that ended the mission.")
      .def_property_readonly("cycles", [](const MissionResult& result) { return result.end.cycles; })
      .def_property_readonly(
          "duration_s", [](const MissionResult& result) { return result.end.duration_s; },
          "By the observations' stamps.")
      .def_property_readonly("distance_m", &MissionResult::distance_m,
                             "Driven: the true distance in a simulation, else by the wheels.")
      .def_property_readonly("is_simulated", &MissionResult::is_simulated)
      .def_property_readonly("collisions", &MissionResult::collisions, "None: not known, of a robot.")
      .def_property_readonly(
          "truth", [](const MissionResult& result) { return result.truth; },
          "Truth at the end; None: of a robot.")
      .def("__repr__",
           [](const MissionResult& result) { return "<MissionResult " + mission_text(result) + ">"; });

  module.def("drive", drive, py::arg("navigator"), py::arg("world") = "", py::arg("vehicle") = "alv-scanner",
             py::kw_only(), py::arg("scenario") = "", py::arg("seed") = 1, py::arg("start") = py::none(),
             py::arg("takes_images") = true, py::arg("connect") = py::none(), py::arg("sensors") = "scanner",
             py::arg("out") = py::none(), py::arg("force") = false, py::arg("duration_max_s") = py::none(),
             py::arg("progress") = py::none(),
             "Lets a navigator drive a simulated vehicle or a robot until it is done, in the loop of every "
             "mission.\n\n"
             "navigator: an object with step(observation: Observation) -> Command or Decision.\n"
             "world, vehicle, scenario, seed, start, takes_images: as of SimulatedVehicle.\n"
             "connect: connection file of a robot that speaks ROS 2, instead of a world.\n"
             "sensors: of a robot, 'scanner' or 'cameras'; each new one of its readings ends a cycle.\n"
             "out: folder of the session that is recorded; None: none is. force: replace it.\n"
             "duration_max_s: the mission fails then; None: it takes as long as the navigator likes.\n"
             "However it ends, by an exception or Ctrl-C as well, the vehicle is commanded to stop.");
}

}  // namespace aisle::python
