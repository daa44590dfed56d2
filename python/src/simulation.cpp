#include <pybind11/stl.h>

#include <cstdint>
#include <memory>
#include <utility>

#include "aisle/commands/shipped_files.hpp"
#include "aisle/commands/simulation_setting.hpp"
#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"

namespace aisle::python {
namespace {

/// A vehicle in a world, which can be set down again and again.
class Simulation {
 public:
  Simulation(SimulationSetting setting, const std::optional<Pose2>& T_world_start, std::uint64_t seed,
             bool takes_images)
      : setting_(std::move(setting)), T_world_start_(T_world_start), takes_images_(takes_images) {
    reset(seed);
  }

  void reset(std::uint64_t seed) {
    const Pose2 start = T_world_start_ ? *T_world_start_ : value_or_raise(start_in(setting_));
    if (!fits(setting_.world, setting_.vehicle.description.footprint, start))
      raise_problems({{{setting_.world_file.string(), 0, "start"}, "the vehicle does not fit there"}});
    const SimulationOptions options{.seed = seed, .T_world_start = start, .takes_images = takes_images_};
    without_lock([&] { vehicle_.emplace(setting_.world, setting_.vehicle, setting_.scenario, options); });
  }

  std::shared_ptr<Observation> sense() {
    return without_lock([&] { return std::make_shared<Observation>(*vehicle_->sense()); });
  }
  void act(const Command& command) { vehicle_->act(command); }

  const VehicleDescription& description() const { return setting_.vehicle.description; }
  const Truth& truth() const { return vehicle_->truth(); }
  const SimulationSetting& setting() const { return setting_; }
  int beams() const { return setting_.vehicle.simulated.scanner.beams; }

 private:
  SimulationSetting setting_;
  std::optional<Pose2> T_world_start_;
  bool takes_images_;
  std::optional<SimulatedVehicle> vehicle_;
};

std::unique_ptr<Simulation> simulate(const std::string& world, const std::string& vehicle,
                                     const std::string& scenario, std::uint64_t seed, const py::object& start,
                                     bool takes_images) {
  std::optional<Pose2> T_world_start;
  if (!start.is_none()) T_world_start = pose_of(start, "start");
  auto setting = value_or_raise(without_lock([&] { return read_setting(world, vehicle, scenario); }));
  return std::make_unique<Simulation>(std::move(setting), T_world_start, seed, takes_images);
}

py::dict places_in(const Simulation& simulation) {
  py::dict places;
  for (const NamedPlace& place : simulation.setting().world.places)
    places[py::str(place.name)] = array_of(place.T_world_place);
  return places;
}

py::dict names_of_shipped(const std::string& kind) {
  py::dict descriptions;
  for (const ShippedFile& file : shipped_files(kind)) descriptions[py::str(file.name)] = file.description;
  return descriptions;
}

}  // namespace

void bind_simulation(py::module_& module) {
  py::class_<Truth>(module, "Truth",
                    "What really happened so far in a simulation: for judging, never for driving.")
      .def_readonly("stamp_s", &Truth::stamp_s)
      .def_property_readonly(
          "pose", [](const Truth& truth) { return array_of(truth.T_world_vehicle); },
          "(3,): x_m, y_m, heading_rad of base_link in `world`.")
      .def_readonly("speed_mps", &Truth::speed_mps, "Of base_link, forwards.")
      .def_readonly("path_m", &Truth::path_m, "Driven, forwards and backwards.")
      .def_readonly("collisions", &Truth::collisions, "How often it has hit something.");

  py::class_<Simulation>(
      module, "SimulatedVehicle",
      "A vehicle in a simulated world. Time advances only in sense(), by one cycle a call; the same seed "
      "and the same commands give the same observations.")
      .def(py::init(&simulate), py::arg("world"), py::arg("vehicle") = "alv-scanner", py::kw_only(),
           py::arg("scenario") = "", py::arg("seed") = 1, py::arg("start") = py::none(),
           py::arg("takes_images") = true,
           "world, vehicle, scenario: files, or names of shipped ones (shipped()); a world may be a floor "
           "plan.\n"
           "seed: of all noise.\n"
           "start: (x_m, y_m, heading_rad) in `world`; None: the world's.\n"
           "takes_images: cameras are traced by rays, which takes most of the time.\n"
           "Raises InputError if one of them cannot be read, or the vehicle does not fit.")
      .def("reset", &Simulation::reset, py::arg("seed") = 1, "Sets the vehicle down anew, at time 0.")
      .def("sense", &Simulation::sense, "Drives one cycle on. Returns its Observation.")
      .def("act", &Simulation::act, py::arg("command"),
           "Takes effect from the next cycle on, until it is too old.")
      .def_property_readonly("vehicle", &Simulation::description, "Vehicle: what it knows of itself.")
      .def_property_readonly("beams", &Simulation::beams, "Of its scanner.")
      .def_property_readonly(
          "truth", [](const Simulation& simulation) { return Truth(simulation.truth()); },
          "Truth, as it is now.")
      .def_property_readonly("places", places_in,
                             "{name: (3,) x_m, y_m, heading_rad in `world`} of the world.")
      .def_property_readonly(
          "warnings", [](const Simulation& simulation) { return simulation.setting().warnings; },
          "[str]: what was guessed in making a world of a plan.");

  module.def("shipped", names_of_shipped, py::arg("kind"),
             "{name: description} of the shipped 'worlds', 'vehicles' or 'scenarios'.");
}

}  // namespace aisle::python
