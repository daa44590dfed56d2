#include "live/live_missions.hpp"

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
#include "live/live_arguments.hpp"
#include "live/live_learning.hpp"

namespace aisle {
namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kSeedMax = 1'000'000'000;

/// What the missions are made from.
struct MissionRequestHandler {
  const LiveOptions& live;
  LiveArguments& arguments;
  Problems& problems;

  std::uint64_t seed() const { return arguments.count("seed", kSeedMax).value_or(live.seed); }
  std::string vehicle() const { return arguments.name("vehicle"); }
  std::string vehicle_or_ours() const {
    std::string asked = vehicle();
    return asked.empty() ? live.vehicle : asked;
  }

  /// A file or folder that is there, or is not there yet; empty for an empty name.
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

DriveOptions hand_drive(const MissionRequestHandler& desk, LiveMission& mission) {
  DriveOptions drive;
  drive.world = desk.live.world;
  drive.vehicle = desk.vehicle_or_ours();
  drive.seed = desk.seed();
  drive.out = desk.new_session(mission.session);
  return drive;
}

LiveMission drive_mission(const MissionRequestHandler& desk, const std::optional<Pose2>& T_world_vehicle) {
  LiveMission mission{
      .name = "drive", .session = desk.arguments.name("session"), .is_driven_by_hand = true, .work = {}};
  DriveOptions options = hand_drive(desk, mission);
  options.T_world_start = T_world_vehicle;
  mission.work = [options](Console& console, const DriveOptions::KeyOperator& hand) {
    DriveOptions driven = options;
    driven.keys = hand;
    return run_drive(driven, console);
  };
  return mission;
}

LiveMission teach_mission(const MissionRequestHandler& desk) {
  LiveMission mission{.name = "teach", .session = desk.arguments.needed_name("session"), .work = {}};
  TeachOptions options;
  options.drive = hand_drive(desk, mission);
  if (const std::string method = desk.arguments.text("method"); !method.empty()) options.method = method;
  if (const std::string route = desk.arguments.text("route"); !route.empty()) options.route = route;
  mission.is_driven_by_hand = !desk.arguments.flag("scripted");
  mission.work = [options, by_hand = mission.is_driven_by_hand](Console& console,
                                                                const DriveOptions::KeyOperator& hand) {
    TeachOptions taught = options;
    if (by_hand) taught.drive.keys = hand;
    return run_teach(taught, console);
  };
  return mission;
}

LiveMission learn_mission(const MissionRequestHandler& desk) {
  LearnOptions options;
  options.sessions = {desk.session(desk.arguments.needed_name("session"))};
  const fs::path building = desk.new_building(desk.arguments.needed_name("building"));
  if (const std::string method = desk.arguments.text("method"); !method.empty()) options.method = method;
  return {.name = "learn", .drives = false, .work = [options, building](Console& console, const auto&) {
            return learn_into(options, building, console);
          }};
}

LiveMission navigate_mission(const MissionRequestHandler& desk) {
  LiveMission mission{.name = "navigate", .session = desk.arguments.name("session"), .work = {}};
  NavigateOptions options;
  options.building = desk.building();
  options.world = desk.live.world;
  options.vehicle = desk.vehicle();
  options.seed = desk.seed();
  options.out = desk.new_session(mission.session);
  options.route = desk.arguments.text("route");
  options.in_reverse = desk.arguments.flag("reverse");
  if (const std::string method = desk.arguments.text("method"); !method.empty()) options.method = method;
  mission.work = [options](Console& console, const auto&) { return run_navigate(options, console); };
  return mission;
}

LiveMission explore_mission(const MissionRequestHandler& desk) {
  ExploreOptions options;
  options.world = desk.live.world;
  options.vehicle = desk.vehicle();
  options.seed = desk.seed();
  const std::string name = desk.arguments.name("building");
  const fs::path building = desk.new_building(name);
  return {.name = "explore", .work = [options, building](Console& console, const auto&) {
            return explore_into(options, building, console);
          }};
}

GuideOptions guided(const MissionRequestHandler& desk, LiveMission& mission) {
  GuideOptions options;
  options.building = desk.building();
  options.world = desk.live.world;
  if (const std::string vehicle = desk.vehicle(); !vehicle.empty()) options.vehicle = vehicle;
  options.seed = desk.seed();
  mission.session = desk.arguments.name("session");
  options.out = desk.new_session(mission.session);
  return options;
}

LiveMission go_mission(const MissionRequestHandler& desk) {
  LiveMission mission{.name = "go", .work = {}};
  GuideOptions options = guided(desk, mission);
  options.place = desk.arguments.text("place");
  const auto x = desk.arguments.number("x_m"), y = desk.arguments.number("y_m");
  if (options.place.empty() && x && y) options.place = fmt::format("{:.3f},{:.3f}", *x, *y);
  if (options.place.empty())
    desk.problems.push_back({{"", 0, "place"}, "is missing, and so are x_m and y_m"});
  mission.work = [options](Console& console, const auto&) { return run_go(options, console); };
  return mission;
}

LiveMission patrol_mission(const MissionRequestHandler& desk) {
  LiveMission mission{.name = "patrol", .work = {}};
  GuideOptions options = guided(desk, mission);
  constexpr std::uint64_t kRounds = 1000;
  options.rounds = static_cast<int>(desk.arguments.count("rounds", kRounds).value_or(1));
  mission.work = [options](Console& console, const auto&) { return run_patrol(options, console); };
  return mission;
}

LiveMission park_mission(const MissionRequestHandler& desk) {
  LiveMission mission{.name = "park", .session = desk.arguments.name("session"), .work = {}};
  ParkOptions options;
  options.building = desk.building();
  options.place = desk.arguments.needed_text("place");
  options.world = desk.live.world;
  options.vehicle = desk.vehicle();
  options.seed = desk.seed();
  options.out = desk.new_session(mission.session);
  mission.work = [options](Console& console, const auto&) { return run_park(options, console); };
  return mission;
}

}  // namespace

Result<LiveMission> live_mission(const LiveOptions& live, const nlohmann::json& arguments,
                                 const std::optional<Pose2>& T_world_vehicle) {
  using Make = std::function<LiveMission(const MissionRequestHandler&)>;
  static const std::map<std::string, Make> missions = {
      {"teach", teach_mission},     {"learn", learn_mission}, {"navigate", navigate_mission},
      {"explore", explore_mission}, {"go", go_mission},       {"patrol", patrol_mission},
      {"park", park_mission}};
  LiveArguments read(arguments);
  Problems problems;
  const MissionRequestHandler desk{live, read, problems};
  const std::string name = read.needed_text("mission");
  const auto known = missions.find(name);
  if (known == missions.end() && name != "drive")
    return Problem{{"", 0, "mission"}, "must be drive, teach, learn, navigate, explore, go, patrol or park"};
  LiveMission mission = name == "drive" ? drive_mission(desk, T_world_vehicle) : known->second(desk);
  const Problems unread = read.problems();
  problems.insert(problems.begin(), unread.begin(), unread.end());
  if (!problems.empty()) return problems;
  return mission;
}

LiveMission live_idling(const LiveOptions& live, const std::optional<Pose2>& T_world_vehicle) {
  DriveOptions options;
  options.world = live.world;
  options.vehicle = live.vehicle;
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
