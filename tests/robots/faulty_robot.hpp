#pragma once

#include <fmt/format.h>

#include <csignal>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fault_relay.hpp"
#include "run_aisle.hpp"
#include "running_robot.hpp"
#include "workplace.hpp"

namespace aisle {

using robots::FaultRelay;

/// A robot and a relay that all tests of the program share, as starting them takes longer than a test.
class FaultyRobot : public Workplace {
 public:
  static void SetUpTestSuite() {
    start_robot();
    start_relay();
  }
  static void TearDownTestSuite() {
    stop.reset();
    drivers_side.reset();
    relay.reset();
    robot.reset();
  }

 protected:
  static constexpr unsigned kLease_s = 3;
  static constexpr double kStandsWithin_s = 0.5;
  static constexpr double kWatched_s = 0.2;  ///< for how long it must then stand at least

  static unsigned robots_domain() { return robots::domain_of_this_process(); }
  static unsigned drivers_domain() { return robots::domain_of_this_process(40); }

  static void start_relay() {
    relay = std::make_unique<FaultRelay>(robots_domain(), drivers_domain(), kLease_s);
    drivers_side = std::make_unique<robots::Participant>(drivers_domain());
    stop =
        std::make_unique<robots::Publisher<robots::Bool>>(*drivers_side, "/stop", robots::Quality::kDefault);
  }

  static void start_robot(const std::vector<std::string>& more = {},
                          const std::string& world = AISLE_SOURCE_DIR "/worlds/l-corridor.yaml") {
    std::vector<std::string> arguments = {"--world", world, "--clock", "--domain",
                                          std::to_string(robots_domain())};
    arguments.insert(arguments.end(), more.begin(), more.end());
    robot = std::make_unique<robots::RunningRobot>(arguments);
    robot->wait_until_ready();
  }

  void SetUp() override { relay->heal(); }

  /// @param more  in place of the usual keys
  std::string connection(const std::string& name = "robot.yaml", const std::string& more = "") const {
    file("cart.yaml",
         "format: aisle.vehicle\nversion: 1\nname: cart\nis_differential: true\n"
         "footprint: {front_m: 0.25, rear_m: 0.1, width_m: 0.3}\n");
    return file(name, fmt::format("format: aisle.connection\nversion: 1\nvehicle: cart.yaml\nclock: ros\n"
                                  "network: {{domain: {}}}\nlimits: {{speed_max_mps: 0.3}}\n{}",
                                  drivers_domain(), more));
  }

  /// From standing, so that what moves next is moved by it.
  static std::unique_ptr<RunningAisle> exploring(const std::string& connection) {
    relay->wait_until([](const FaultRelay& r) { return r.robot_time_s() > r.last_motion_s() + kWatched_s; });
    return std::make_unique<RunningAisle>(Arguments{"explore", "--connect", connection, "--json"});
  }

  static bool is_driving() {
    return relay->wait_until([](const FaultRelay& r) { return r.speed_mps() > 0.15; });
  }

  static void expect_it_drives_on(const RunningAisle& aisle) {
    EXPECT_TRUE(is_driving()) << aisle.error_so_far();
  }

  /// @param known_s  when the fault counts as one, by the robot's clock
  static void expect_standing_from(double known_s) {
    const double still_s = known_s + kStandsWithin_s;
    relay->wait_until([&](const FaultRelay& r) { return r.robot_time_s() > still_s + kWatched_s; });
    EXPECT_LT(relay->last_motion_s(), still_s) << "of the robot's time; it counts as a fault at " << known_s;
  }

  static bool says(const RunningAisle& aisle, const std::string& words) {
    return relay->wait_until(
        [&](const FaultRelay&) { return aisle.error_so_far().find(words) != std::string::npos; });
  }

  static inline std::unique_ptr<robots::RunningRobot> robot;
  static inline std::unique_ptr<FaultRelay> relay;
  static inline std::unique_ptr<robots::Participant> drivers_side;
  static inline std::unique_ptr<robots::Publisher<robots::Bool>> stop;
};

}  // namespace aisle
