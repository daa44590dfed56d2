#include "live_missions.hpp"

#include <fmt/format.h>

#include <map>
#include <system_error>
#include <utility>

#include "aisle/commands/explore.hpp"
#include "aisle/commands/guide.hpp"
#include "aisle/commands/learn.hpp"
#include "aisle/commands/navigate.hpp"
#include "aisle/commands/park.hpp"
#include "aisle/commands/teach.hpp"
#include "live_arguments.hpp"
#include "live_goals.hpp"
#include "live_learning.hpp"

namespace aisle {
namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kSeedMax = 1'000'000'000;

/// What missions are made from: the live options and the arguments of the request. Collects problems.
struct MissionRequest {
  const LiveOptions& live;
  LiveArguments& arguments;
  Problems& problems;

  std::uint64_t seed() const { return arguments.count("seed", kSeedMax).value_or(live.seed); }
  /// The one that the request names, or that the server was started with; empty: the mission's usual one.
  std::string vehicle() const {
    std::string asked = arguments.name("vehicle");
    return asked.empty() ? live.vehicle : asked;
  }

  /// Path of a file or folder that must exist, or must not exist if `is_new`; empty for an empty name.
  fs::path kept(const fs::path& folder, const char* key, const std::string& name, const char* ending,
                bool is_new) const {
    if (name.empty()) return {};
    if (folder.empty()) {
      problems.push_back(
          {{"", 0, key}, "the server was started without a folder for it: --out, --sessions, --buildings"});
      return {};
    }
    fs::path path = folder / (name + ending);
    std::error_code error;
    if (fs::exists(path, error) == is_new)
      problems.push_back(
          {{"", 0, key},
           is_new ? fmt::format("'{}' is there already", name) : fmt::format("there is no '{}'", name)});
    return path;
  }
  fs::path new_session(const std::string& name) const {
    return kept(live.listening.sessions, "session", name, "", true);
  }
  fs::path session(const std::string& name) const {
    return kept(live.listening.sessions, "session", name, "", false);
  }
  fs::path new_building(const std::string& name) const {
    return kept(live.listening.buildings, "building", name, ".json", true);
  }
  fs::path building() const {
    return kept(live.listening.buildings, "building", arguments.needed_name("building"), ".json", false);
  }
};

DriveOptions hand_drive(const MissionRequest& request, LiveMission& mission) {
  DriveOptions drive;
  drive.connection = request.live.connection;
  drive.world = request.live.world;
  if (const std::string vehicle = request.vehicle(); !vehicle.empty()) drive.vehicle = vehicle;
  drive.seed = request.seed();
  drive.out = request.new_session(mission.session);
  return drive;
}

LiveMission drive_mission(const MissionRequest& request, const std::optional<Pose2>& T_world_vehicle) {
  LiveMission mission{
      .name = "drive", .session = request.arguments.name("session"), .is_driven_by_hand = true, .work = {}};
  DriveOptions options = hand_drive(request, mission);
  options.T_world_start = T_world_vehicle;
  mission.work = [options](Console& console, const DriveOptions::KeyOperator& hand) {
    DriveOptions driven = options;
    driven.keys = hand;
    return run_drive(driven, console);
  };
  return mission;
}

LiveMission teach_mission(const MissionRequest& request) {
  LiveMission mission{.name = "teach", .session = request.arguments.needed_name("session"), .work = {}};
  TeachOptions options;
  options.drive = hand_drive(request, mission);
  if (const std::string method = request.arguments.text("method"); !method.empty()) options.method = method;
  if (const std::string route = request.arguments.text("route"); !route.empty()) options.route = route;
  mission.is_driven_by_hand = !request.arguments.flag("scripted");
  if (!mission.is_driven_by_hand && !request.live.connection.empty())
    request.problems.push_back({{"", 0, "scripted"}, "a scripted person cannot drive a robot"});
  mission.work = [options, by_hand = mission.is_driven_by_hand](Console& console,
                                                                const DriveOptions::KeyOperator& hand) {
    TeachOptions taught = options;
    if (by_hand) taught.drive.keys = hand;
    return run_teach(taught, console);
  };
  return mission;
}

LiveMission learn_mission(const MissionRequest& request) {
  LearnOptions options;
  options.sessions = {request.session(request.arguments.needed_name("session"))};
  const fs::path building = request.new_building(request.arguments.needed_name("building"));
  if (const std::string method = request.arguments.text("method"); !method.empty()) options.method = method;
  return {.name = "learn", .drives = false, .work = [options, building](Console& console, const auto&) {
            return learn_into(options, building, console);
          }};
}

LiveMission navigate_mission(const MissionRequest& request) {
  LiveMission mission{.name = "navigate", .session = request.arguments.name("session"), .work = {}};
  NavigateOptions options;
  options.building = request.building();
  options.connection = request.live.connection;
  options.world = request.live.world;
  options.vehicle = request.vehicle();
  options.seed = request.seed();
  options.out = request.new_session(mission.session);
  options.route = request.arguments.text("route");
  options.in_reverse = request.arguments.flag("reverse");
  if (const std::string method = request.arguments.text("method"); !method.empty()) options.method = method;
  mission.work = [options](Console& console, const auto&) { return run_navigate(options, console); };
  return mission;
}

LiveMission explore_mission(const MissionRequest& request) {
  ExploreOptions options;
  options.connection = request.live.connection;
  options.world = request.live.world;
  options.vehicle = request.vehicle();
  options.seed = request.seed();
  const std::string name = request.arguments.name("building");
  const fs::path building = request.new_building(name);
  return {.name = "explore", .work = [options, building](Console& console, const auto&) {
            return explore_into(options, building, console);
          }};
}

GuideOptions guided(const MissionRequest& request, LiveMission& mission) {
  GuideOptions options;
  options.building = request.building();
  options.connection = request.live.connection;
  options.world = request.live.world;
  if (const std::string vehicle = request.vehicle(); !vehicle.empty()) options.vehicle = vehicle;
  options.seed = request.seed();
  mission.session = request.arguments.name("session");
  options.out = request.new_session(mission.session);
  return options;
}

LiveMission go_mission(const MissionRequest& request) {
  LiveMission mission{.name = "go", .work = {}};
  GuideOptions options = guided(request, mission);
  if (const auto* list = request.arguments.value("goals")) {
    options.places = goals_in(*list, request.problems);
  } else if (std::string goal = goal_in(request.arguments); !goal.empty()) {
    options.places = {std::move(goal)};
  }
  if (options.places.empty())
    request.problems.push_back({{"", 0, "place"}, "is missing, and so are x_m and y_m, and goals"});
  mission.work = [options](Console& console, const auto&) { return run_go(options, console); };
  return mission;
}

LiveMission patrol_mission(const MissionRequest& request) {
  LiveMission mission{.name = "patrol", .work = {}};
  GuideOptions options = guided(request, mission);
  constexpr std::uint64_t kRounds = 1000;
  options.rounds = static_cast<int>(request.arguments.count("rounds", kRounds).value_or(1));
  mission.work = [options](Console& console, const auto&) { return run_patrol(options, console); };
  return mission;
}

LiveMission park_mission(const MissionRequest& request) {
  LiveMission mission{.name = "park", .session = request.arguments.name("session"), .work = {}};
  ParkOptions options;
  options.building = request.building();
  options.place = request.arguments.needed_text("place");
  options.connection = request.live.connection;
  options.world = request.live.world;
  options.vehicle = request.vehicle();
  options.seed = request.seed();
  options.out = request.new_session(mission.session);
  mission.work = [options](Console& console, const auto&) { return run_park(options, console); };
  return mission;
}

}  // namespace

Result<LiveMission> live_mission(const LiveOptions& live, const nlohmann::json& arguments,
                                 const std::optional<Pose2>& T_world_vehicle) {
  using Make = std::function<LiveMission(const MissionRequest&)>;
  static const std::map<std::string, Make> missions = {
      {"teach", teach_mission},     {"learn", learn_mission}, {"navigate", navigate_mission},
      {"explore", explore_mission}, {"go", go_mission},       {"patrol", patrol_mission},
      {"park", park_mission}};
  LiveArguments read(arguments);
  Problems problems;
  const MissionRequest request{live, read, problems};
  const std::string name = read.needed_text("mission");
  const auto known = missions.find(name);
  if (known == missions.end() && name != "drive")
    return Problem{{"", 0, "mission"}, "must be drive, teach, learn, navigate, explore, go, patrol or park"};
  LiveMission mission = name == "drive" ? drive_mission(request, T_world_vehicle) : known->second(request);
  const Problems unread = read.problems();
  problems.insert(problems.begin(), unread.begin(), unread.end());
  if (!problems.empty()) return problems;
  return mission;
}

std::string waiting_vehicle(const LiveOptions& live) {
  return live.vehicle.empty() ? DriveOptions{}.vehicle : live.vehicle;
}

LiveMission live_idling(const LiveOptions& live, const std::optional<Pose2>& T_world_vehicle) {
  DriveOptions options;
  options.connection = live.connection;
  options.world = live.world;
  options.vehicle = waiting_vehicle(live);
  options.seed = live.seed;
  options.T_world_start = T_world_vehicle;
  return {.is_driven_by_hand = true,
          .work = [options](Console& console, const DriveOptions::KeyOperator& hand) {
            DriveOptions driven = options;
            driven.keys = hand;
            return run_drive(driven, console);
          }};
}

}  // namespace aisle
