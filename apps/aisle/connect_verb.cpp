#include <memory>

#include "aisle/commands/connect.hpp"
#include "examples.hpp"
#include "option_kinds.hpp"
#include "verb.hpp"

using namespace aisle;

namespace {

void add_network_options(CLI::App& verb, ConnectOptions& options) {
  ConnectedNetwork& network = options.network;
  verb.add_option("--domain", network.domain, "ROS domain (default 0)")->check(CLI::Range(0, 101));
  verb.add_option("--interface", network.interface_address,
                  "address of this machine to listen on (default 127.0.0.1: this machine alone)");
  verb.add_option("--peer", network.peers, "IPv4 address to look for the robot at (default 127.0.0.1)");
  verb.add_flag("--multicast", network.multicast, "also announce aisle to robots that look for no peers");
}

void add_seconds(CLI::App& verb, ConnectOptions& options) {
  verb.add_option("--seconds", options.listen_s, "how long to look and to listen (default 3)")
      ->check(CLI::Range(0.5, 600.0));
}

CLI::Option* add_connection(CLI::App& verb, ConnectOptions& options) {
  return verb.add_option("--connect", options.connection, "connection file (YAML) of the robot");
}

CLI::App* add_below(CLI::App& connect, const char* name, const char* meaning) {
  CLI::App* verb = connect.add_subcommand(name, meaning);
  verb->fallthrough();
  return verb;
}

using Run = Result<Outcome> (*)(const ConnectOptions&, Console&);

/// A verb that takes a connection file, or looks around in a network.
void add_looking_verb(CLI::App& connect, Work& work, const char* name, const char* meaning, Run run,
                      std::initializer_list<std::string_view> examples) {
  CLI::App* verb = add_below(connect, name, meaning);
  add_examples(*verb, examples);
  auto options = std::make_shared<ConnectOptions>();
  CLI::Option* const connection = add_connection(*verb, *options);
  add_network_options(*verb, *options);
  for (const char* setting : {"--domain", "--interface", "--peer", "--multicast"})
    connection->excludes(verb->get_option(setting));  // the file says them
  add_seconds(*verb, *options);
  verb->callback(
      [options, run, &work] { work = [options, run](Console& console) { return run(*options, console); }; });
}

void add_try_verb(CLI::App& connect, Work& work) {
  CLI::App* verb = add_below(connect, "try",
                             "move the robot by 0.1 m and 10 degrees, and compare with what it says it did");
  add_examples(*verb, {"aisle connect try --connect robot.yaml"});
  auto options = std::make_shared<ConnectOptions>();
  add_connection(*verb, *options)->required();
  verb->callback([options, &work] {
    work = [options](Console& console) { return run_connect_try(*options, console); };
  });
}

Footprint parse_size(const std::vector<double>& size) {
  Footprint footprint;
  footprint.front_m = size[0];
  footprint.rear_m = size[1];
  footprint.width_m = size[2];
  return footprint;
}

void add_init_verb(CLI::App& connect, Work& work) {
  CLI::App* verb = add_below(connect, "init", "write a connection file from what is found in the network");
  add_examples(*verb, {"aisle connect init --footprint 0.18,0.18,0.36 --speed-max 0.3 --out robot.yaml",
                       "aisle connect init --vehicle turtlebot --domain 5 --out robot.yaml"});
  auto options = std::make_shared<ConnectInitOptions>();
  verb->add_option("-o,--out", options->out, "connection file (YAML) to write")->required();
  verb->add_option("--vehicle", options->vehicle, "vehicle file (YAML) or name of a shipped vehicle");
  verb->add_option_function<std::vector<double>>(
          "--footprint",
          [options](const std::vector<double>& size) { options->footprint = parse_size(size); },
          "front, rear and width of a new vehicle file [m], from the middle of the driven axle")
      ->type_name("FRONT,REAR,WIDTH")
      ->delimiter(',')
      ->expected(3)
      ->check(CLI::Range(0.0, 10.0));
  verb->add_flag("--front-steered", options->is_front_steered, "front wheels steer (default: differential)");
  verb->add_option("--wheelbase", options->wheelbase_m, "of a front-steered robot [m]")
      ->check(CLI::Range(0.01, 10.0));
  verb->add_option("--speed-max", options->speed_max_mps, "how fast it may drive [m/s] (default 0.3)")
      ->check(CLI::Range(0.01, 10.0));
  verb->add_flag("--force", options->force, "overwrite existing files");
  add_network_options(*verb, options->find);
  add_seconds(*verb, options->find);
  verb->callback([options, &work] {
    work = [options](Console& console) { return run_connect_init(*options, console); };
  });
}

}  // namespace

void add_connect_verb(CLI::App& app, Work& work) {
  CLI::App* connect = app.add_subcommand("connect", "see, check and try a robot that speaks ROS 2");
  connect->require_subcommand(1);
  connect->fallthrough();
  add_looking_verb(*connect, work, "list",
                   "list the topics of a ROS 2 network, and what each could serve for", run_connect_list,
                   {"aisle connect list", "aisle connect list --interface 192.168.0.5 --peer 192.168.0.7"});
  add_looking_verb(
      *connect, work, "check", "listen to a robot and say whether it could be driven; commands nothing",
      run_connect_check,
      {"aisle connect check --connect robot.yaml", "aisle connect check --connect robot.yaml --seconds 10"});
  add_try_verb(*connect, work);
  add_init_verb(*connect, work);
  add_examples(*connect,
               {"aisle connect list", "aisle connect init --footprint 0.18,0.18,0.36 --out robot.yaml",
                "aisle connect check --connect robot.yaml"});
}
