#include "aisle/commands/fleet.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "aisle/commands/driven_vehicle.hpp"
#include "aisle/commands/mqtt_fleet_link.hpp"
#include "aisle/commands/parameter_listing.hpp"
#include "aisle/commands/set_down.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/formats/whole_file.hpp"
#include "aisle/missions/exploration/fleet_driver.hpp"
#include "aisle/missions/exploration/fleet_mission.hpp"
#include "fleet/paced_vehicle.hpp"

namespace aisle {
namespace {

Result<FleetDriverParams> fleet_driver_params(const FleetOptions& options) {
  FleetDriverParams params;
  FieldList fields = fields_of(params);
  if (Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  return params;
}

Result<Outcome> write_lif(const FleetOptions& options, const FleetDriverParams& params) {
  if (!options.force && std::filesystem::exists(options.lif))
    return Problem{{options.lif.string()}, "exists already; --force replaces it"};
  const auto building = read_building(options.building);
  if (!building) return building.problems();
  const FleetGraph graph = fleet_graph(*building, params.node_spacing_m);
  if (graph.nodes.empty())
    return Problem{{options.building.string(), 0, "corridors"}, "are missing, so there is no graph"};
  if (Problems problems = write_whole_file(options.lif, lif_json(graph, *building, utc_timestamp()));
      !problems.empty())
    return problems;
  Outcome outcome{.verb = "fleet"};
  outcome.figures = {
      {"nodes", graph.nodes.size()}, {"edges", graph.edges.size()}, {"stations", graph.stations.size()}};
  outcome.files["lif"] = options.lif.string();
  outcome.text = fmt::format("{}: {} nodes, {} edges, {} stations\n", options.lif.string(),
                             graph.nodes.size(), graph.edges.size(), graph.stations.size());
  return outcome;
}

Result<MqttSettings> broker_settings(const FleetOptions& options) {
  MqttSettings settings;
  settings.url = options.broker;
  settings.user = options.user;
  settings.ca_file = options.ca_file.string();
  if (!options.ca_file.empty()) {
    if (const auto pem = read_whole_file(options.ca_file); !pem) return pem.problems();
  }
  if (options.password_file.empty()) return settings;
  const auto text = read_whole_file(options.password_file);
  if (!text) return text.problems();
  settings.password = text->substr(0, text->find_first_of("\r\n"));
  if (settings.password.empty()) return Problem{{options.password_file.string()}, "its first line is empty"};
  return settings;
}

/// Ends the mission once enough orders are done, and otherwise when the user does.
class FleetProgress final : public Progress {
 public:
  FleetProgress(Progress& progress, const FleetDriver& driver, std::size_t orders)
      : progress_(progress), driver_(driver), orders_(orders) {}

  void report(std::string_view task, std::size_t done, std::size_t total) override {
    progress_.report(task, done, total);
  }
  bool shall_end() const override { return has_done_enough() || progress_.shall_end(); }
  bool has_done_enough() const { return orders_ > 0 && driver_.tracker().orders_done() >= orders_; }

 private:
  Progress& progress_;
  const FleetDriver& driver_;
  std::size_t orders_;
};

Outcome fleet_outcome(const FleetOptions& options, const FleetDriver& driver, const MissionResult& result,
                      std::size_t connections) {
  const OrderTracker& tracker = driver.tracker();
  const bool is_enough = options.orders == 0 || tracker.orders_done() >= options.orders;
  Outcome outcome{.verb = "fleet", .ok = is_enough && result.is_unharmed()};
  outcome.figures = known_figures({{"orders_done", tracker.orders_done()},
                                   {"orders_refused", tracker.orders_refused()},
                                   {"connections", connections},
                                   {"times_lost", driver.times_lost()},
                                   {"why", result.end.why},
                                   {"distance_m", rounded(result.distance_m(), 3)},
                                   {"collisions", if_known(result.collisions())},
                                   {"duration_s", rounded(result.end.duration_s, 1)}});
  outcome.text =
      fmt::format("{}{} orders done, {} refused; {:.1f} m in {:.0f} s{}\n",
                  result.is_simulated() ? "simulated: " : "", tracker.orders_done(), tracker.orders_refused(),
                  result.distance_m(), result.end.duration_s, collisions_text(result));
  return outcome;
}

}  // namespace

Outcome fleet_parameters() {
  FleetDriverParams params;
  return parameter_listing("fleet", fields_of(params));
}

Result<Outcome> run_fleet(const FleetOptions& options, Console& console) {
  const auto params = fleet_driver_params(options);
  if (!params) return params.problems();
  if (!options.lif.empty()) return write_lif(options, *params);
  const auto settings = broker_settings(options);
  if (!settings) return settings.problems();
  const auto building = read_whole_file(options.building);
  if (!building) return building.problems();
  const auto opened = DrivenVehicle::open({.connection = options.connection,
                                           .world = options.world,
                                           .vehicle = options.vehicle,
                                           .scenario = options.scenario,
                                           .seed = options.seed},
                                          DrivenBy::kScanner, console);
  if (!opened) return opened.problems();
  DrivenVehicle& driven = **opened;
  if (driven.setting() != nullptr) driven.setting()->vehicle.description.cameras.clear();
  const auto link = MqttFleetLink::connect(*settings, options.identity);
  if (!link) return link.problems();
  const MissionStart elsewhere{.is_unknown = options.T_world_start.has_value(), .T_map_hint = {}};
  const auto driver =
      FleetDriver::make(*params, *building, driven.description(), options.told.value_or(elsewhere),
                        options.identity, **link, utc_timestamp);
  if (!driver) return at_file(driver.problems(), options.building.string());
  if (Problems problems = set_down_at_home_or(options.T_world_start, driven, options.seed); !problems.empty())
    return problems;

  PacedVehicle paced(driven.vehicle(), options.rate);
  const bool is_paced = driven.setting() != nullptr;
  Vehicle& vehicle = is_paced ? static_cast<Vehicle&>(paced) : driven.vehicle();
  auto shown =
      open_session({}, false, SessionStorage::kSqlite, vehicle, driven.truth(), {}, driven.watcher(console));
  if (!shown) return shown.problems();
  FleetProgress progress(console.progress, **driver, options.orders);
  const auto result = drive_in_fleet(vehicle, driven.truth(), **driver, *shown, progress);
  (*link)->disconnect();
  if (!result) return result.problems();
  Outcome outcome = fleet_outcome(options, **driver, *result, (*link)->connections());
  driven.add_to(outcome.figures);
  return outcome;
}

}  // namespace aisle
