#include <memory>

#include "aisle/commands/fleet.hpp"
#include "examples.hpp"
#include "live_options.hpp"
#include "option_kinds.hpp"
#include "vehicle_options.hpp"
#include "verb.hpp"

using namespace aisle;

namespace {

void add_broker_options(CLI::App& verb, FleetOptions& options) {
  verb.add_option("--broker", options.broker,
                  "MQTT broker: mqtt://HOST[:PORT], or mqtts://HOST[:PORT] by TLS");
  verb.add_option("--manufacturer", options.identity.manufacturer,
                  "manufacturer in the vehicle's topics (default aisle)");
  verb.add_option("--serial", options.identity.serial,
                  "serial number in the vehicle's topics (default 0001)");
  verb.add_option("--user", options.user, "user at the broker (default: no login)");
  verb.add_option("--password-file", options.password_file, "file whose first line is the user's password")
      ->needs("--user");
  verb.add_option("--ca", options.ca_file,
                  "certificates (PEM) that vouch for the broker (default: those that the machine trusts)");
  verb.add_option("--orders", options.orders, "leave after so many orders (default: stay until interrupted)");
}

void add_fleet_vehicle_options(CLI::App& verb, FleetOptions& options) {
  verb.add_option("--world", options.world,
                  "world file (YAML) or name of a shipped world: drive a simulated vehicle in it");
  verb.add_option_function<std::string>(
      "--start",
      [&options](const std::string& text) { options.T_world_start = parse_place("--start", text); },
      "put the simulated vehicle down at x,y,heading_deg of the world (default: at home)");
  verb.add_option_function<std::string>(
      "--at", [&options](const std::string& text) { options.told = parse_told_start(text); },
      "where it begins: home, unknown (it finds itself, standing), or x,y,heading_deg in the map, which is "
      "checked (default: home; unknown with --start)");
  verb.add_option("--vehicle", options.vehicle,
                  "vehicle file (YAML) or name of a shipped vehicle (default alv-scanner)");
  verb.add_option(
      "--faults", options.scenario,
      "scenario file (YAML) of faults to inject, or name of a shipped scenario (default: no faults)");
  add_seed(verb, options.seed, "random seed; the same seed gives the same sensor noise (default 1)");
  verb.add_option("--pace", options.rate, "simulated seconds per second (default 1)")
      ->check(CLI::Range(0.1, 100.0));
  add_robot(verb, options.connection, {"--world", "--start", "--vehicle", "--faults", "--seed", "--pace"});
}

}  // namespace

void add_fleet_verb(CLI::App& app, Work& work) {
  CLI::App* verb =
      app.add_subcommand("fleet", "drive in a fleet, by VDA 5050 over MQTT: what its master control orders");
  verb->fallthrough();
  add_examples(
      *verb, {"aisle fleet building.json --broker mqtt://localhost --connect robot.yaml --serial 0007",
              "aisle fleet out/office/building.json --broker mqtts://broker.example --ca ca.pem --user robot "
              "--password-file secret.txt --world small-office",
              "aisle fleet out/office/building.json --lif out/office.lif.json"});
  auto options = std::make_shared<FleetOptions>();
  verb->add_option("BUILDING", options->building, "building file (JSON) from 'aisle explore'");
  add_broker_options(*verb, *options);
  add_fleet_vehicle_options(*verb, *options);
  verb->add_option("--lif", options->lif,
                   "only write the building's graph for the master control here, as LIF (JSON)");
  verb->add_flag("--force", options->force, "overwrite an existing file");
  const LiveOption live(*verb);
  add_parameter_options(*verb, options->parameters, fleet_parameters, work, [=, &work] {
    if (options->building.empty()) throw CLI::RequiredError("BUILDING");
    if (options->lif.empty()) {
      if (options->broker.empty()) throw CLI::RequiredError("--broker");
      require_vehicle(options->world, options->connection);
    }
    work = live.around([options](Console& console, const auto&) { return run_fleet(*options, console); });
  });
}
