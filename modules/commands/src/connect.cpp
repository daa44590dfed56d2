#include "aisle/commands/connect.hpp"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "aisle/commands/connected_robot.hpp"
#include "aisle/commands/output_directory.hpp"
#include "aisle/connection/robot_try.hpp"
#include "aisle/connection/topic_survey.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/formats/worlds/vehicle_yaml.hpp"
#include "connect_check.hpp"

namespace aisle {
namespace {

constexpr double kAsk_s = 0.1;

/// A network, with nothing that is driven in it.
struct Network {
  std::unique_ptr<Wire> wire;
  std::vector<SurveyedTopic> topics;
};

Result<Network> look_around(const ConnectedNetwork& settings, double listen_s, Progress& progress) {
  auto wire = Wire::open(wire_settings(settings));
  if (!wire) return wire.problems();
  const SteadyClock clock;
  const double until_s = clock.now_s() + listen_s;
  while (clock.now_s() < until_s) {
    progress.report("looking for topics", 0, 0);
    std::this_thread::sleep_for(std::chrono::duration<double>(kAsk_s));
  }
  std::vector<SurveyedTopic> topics = survey((*wire)->endpoints());
  return Network{std::move(*wire), std::move(topics)};
}

nlohmann::ordered_json topics_json(const std::vector<SurveyedTopic>& topics) {
  auto list = nlohmann::ordered_json::array();
  for (const SurveyedTopic& topic : topics) {
    list.push_back({{"name", topic.name},
                    {"type", topic.type},
                    {"publishers", topic.publishers},
                    {"subscribers", topic.subscribers},
                    {"reliable", topic.reliable},
                    {"latched", topic.latched},
                    {"use", topic.use}});
  }
  return list;
}

std::string topics_text(const std::vector<SurveyedTopic>& topics, const ConnectedNetwork& network) {
  std::string text = fmt::format("{} topics in domain {} at {}\n", topics.size(), network.domain,
                                 fmt::join(network.peers, ", "));
  for (const SurveyedTopic& topic : topics)
    text += fmt::format("  {:<32} {:<36} {} -> {}{}\n", topic.name, topic.type, topic.publishers,
                        topic.subscribers, topic.use.empty() ? "" : "  could serve as " + topic.use);
  if (topics.empty())
    text +=
        "  Is the robot running, in the same domain (ROS_DOMAIN_ID), at this address? '--multicast' lets "
        "robots find aisle that do not look for peers.\n";
  return text;
}

/// The connection of the file, else one that names the network alone.
Result<Connection> connection_of(const ConnectOptions& options) {
  if (options.connection.empty()) return Connection{.network = options.network};
  return read_connection(options.connection);
}

/// For what is checked without a file, any vehicle is as good.
VehicleDescription any_vehicle() {
  VehicleDescription vehicle;
  vehicle.is_differential = true;
  return vehicle;
}

nlohmann::ordered_json pose_json(const Pose2& T) {
  return {
      {"x_m", rounded(T.x, 4)}, {"y_m", rounded(T.y, 4)}, {"heading_deg", rounded(to_degrees(T.theta), 2)}};
}

std::string move_text(const TriedMove& move) {
  const auto text = [](const Pose2& T) {
    return fmt::format("{:6.3f} m {:6.1f} deg", T.x, to_degrees(T.theta));
  };
  return fmt::format("  {:<18} commanded {}   odometry {}   scans {}\n", move.name, text(move.commanded),
                     text(move.by_odometry), text(move.by_scans));
}

Outcome outcome_of(const RobotTry& tried) {
  Outcome outcome{.verb = "connect try", .ok = tried.problems.empty()};
  auto moves = nlohmann::ordered_json::array();
  outcome.text = outcome.ok ? "the robot moves as commanded\n" : "the robot does NOT move as commanded\n";
  for (const TriedMove& move : tried.moves) {
    moves.push_back({{"name", move.name},
                     {"commanded", pose_json(move.commanded)},
                     {"by_odometry", pose_json(move.by_odometry)},
                     {"by_scans", pose_json(move.by_scans)}});
    outcome.text += move_text(move);
  }
  for (const Problem& problem : tried.problems) outcome.text += to_string(problem) + "\n";
  outcome.figures = {{"moves", std::move(moves)}, {"problems", warnings_json(tried.problems)}};
  if (!outcome.ok) return outcome;
  outcome.figures["stops_by_itself"] = tried.stops_by_itself;
  outcome.text +=
      tried.stops_by_itself
          ? "it stops by itself when commands end\n"
          : "it does NOT stop by itself when commands end: if the network or aisle fails while it "
            "drives, nothing stops it. Set its driver's command time-out.\n";
  return outcome;
}

/// The text of a vehicle file, which is as the reader wants it.
Result<std::string> new_vehicle(const ConnectInitOptions& options) {
  if (!options.footprint)
    return Problem{
        {"connect init"},
        "cannot know the robot's size: give '--footprint FRONT,REAR,WIDTH' in metres from the middle of "
        "its driven axle, or '--vehicle' with a vehicle file or the name of a shipped one"};
  VehicleDescription vehicle;
  vehicle.name = options.out.stem().string();
  vehicle.is_differential = !options.is_front_steered;
  vehicle.footprint = *options.footprint;
  vehicle.limits.speed_max_mps = options.speed_max_mps;
  vehicle.limits.reverse_speed_max_mps = options.speed_max_mps / 2;
  if (!options.is_front_steered) {
    vehicle.differential.wheel_separation_m = options.footprint->width_m;
  } else if (options.wheelbase_m > 0) {
    vehicle.front_steered.wheelbase_m = options.wheelbase_m;
  } else {
    return Problem{{"connect init"}, "a front-steered robot needs its '--wheelbase' in metres"};
  }
  std::string text = vehicle_yaml(vehicle);
  if (auto read = parse_vehicle(text, "the new vehicle file"); !read) return read.problems();
  return text;
}

}  // namespace

Result<Outcome> run_connect_list(const ConnectOptions& options, Console& console) {
  const auto connection = connection_of(options);
  if (!connection) return connection.problems();
  const ConnectedNetwork& network = connection->network;
  const auto around = look_around(network, options.listen_s, console.progress);
  if (!around) return around.problems();
  Outcome outcome{.verb = "connect list", .ok = !around->topics.empty()};
  outcome.figures = {{"domain", network.domain}, {"topics", topics_json(around->topics)}};
  outcome.text = topics_text(around->topics, network);
  return outcome;
}

Result<Outcome> run_connect_check(const ConnectOptions& options, Console& console) {
  const bool has_file = !options.connection.empty();
  auto connection = connection_of(options);
  if (!connection) return connection.problems();
  const auto vehicle = has_file ? vehicle_of(*connection) : any_vehicle();
  if (!vehicle) return vehicle.problems();
  const auto around = look_around(connection->network, options.listen_s, console.progress);
  if (!around) return around.problems();
  Problems warnings;
  if (!has_file) connection = suggested_connection(around->topics, std::move(*connection), warnings);
  if (!connection) return connection.problems();
  const SteadyClock clock;
  const auto check = check_robot(*connection, *vehicle,
                                 {*around->wire, clock, console.progress, console.warn}, options.listen_s);
  if (!check) return check.problems();
  warnings.insert(warnings.end(), check->warnings.begin(), check->warnings.end());
  warn_of(warnings, console);
  Outcome outcome{.verb = "connect check"};
  outcome.figures = figures_of(*check);
  outcome.figures["topics"] = topics_json(around->topics);
  outcome.figures["warnings"] = warnings_json(warnings);
  outcome.text = check_text(*check);
  return outcome;
}

Result<Outcome> run_connect_try(const ConnectOptions& options, Console& console) {
  auto robot = connect_robot(options.connection, DrivenBy::kScanner, console);
  if (!robot) return robot.problems();
  const auto tried = try_robot(*(*robot)->vehicle);
  if (!tried) return tried.problems();
  return outcome_of(*tried);
}

Result<Outcome> run_connect_init(const ConnectInitOptions& options, Console& console) {
  const std::string file = options.out.filename().string();
  const std::string vehicle_file = options.out.stem().string() + "-vehicle.yaml";
  std::vector<OutputFile> files;
  Connection known{.file = options.out.string(), .vehicle = options.vehicle, .network = options.find.network};
  if (!options.vehicle.empty()) {
    if (const auto vehicle = vehicle_of(known); !vehicle) return vehicle.problems();
  } else {
    auto text = new_vehicle(options);
    if (!text) return text.problems();
    files.push_back({"vehicle", vehicle_file, std::move(*text)});
    known.vehicle = vehicle_file;
  }
  std::vector<std::string> names{file};
  for (const OutputFile& made : files) names.push_back(made.name);
  auto directory = OutputDirectory::open(
      options.out.has_parent_path() ? options.out.parent_path() : std::filesystem::path("."), options.force,
      names);
  if (!directory) return directory.problems();
  const auto around = look_around(options.find.network, options.find.listen_s, console.progress);
  if (!around) return around.problems();
  Problems warnings;
  const auto connection = suggested_connection(around->topics, std::move(known), warnings);
  if (!connection) {
    Problems problems = connection.problems();
    problems.back().what += "; " + topics_text(around->topics, options.find.network);
    return problems;
  }
  files.push_back({"connection", file, connection_yaml(*connection)});
  auto written = directory->write(files);
  if (!written) return written.problems();
  warn_of(warnings, console);
  Outcome outcome{.verb = "connect init"};
  outcome.figures = {{"topics", topics_json(around->topics)},
                     {"scan", connection->scan.topic},
                     {"odometry", connection->odometry.topic},
                     {"command", connection->commands.topic},
                     {"warnings", warnings_json(warnings)}};
  outcome.files = std::move(*written);
  std::string cameras;
  for (const ConnectedCamera& camera : connection->cameras)
    cameras += fmt::format(", camera '{}' {}", camera.name, camera.topic);
  outcome.text = fmt::format(
      "wrote {}: {}odometry {}, commands {}{}\nnext: aisle connect check --connect {}\n",
      options.out.string(),
      connection->scan.topic.empty() ? std::string() : fmt::format("scans {}, ", connection->scan.topic),
      connection->odometry.topic, connection->commands.topic, cameras, options.out.string());
  return outcome;
}

}  // namespace aisle
