#include "aisle/connection/robot_viewer.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "scripted_robot.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Keeps what it hears of the battery.
class BatteryWatcher final : public MessageSink {
 public:
  void take(const SessionTopic& topic, ros::Stamp_ns, std::string_view cdr) override {
    if (topic.name == "/battery") said.push_back(parse_cdr<ros::String>(cdr)->data);
  }
  std::vector<std::string> said;
};

class RobotViewerTest : public testing::Test {
 protected:
  void say_charge(float charge) {
    ros::BatteryState battery;
    battery.percentage = charge;
    robot.wire.tell("/battery", cdr_bytes(battery));
  }
  /// The vehicle drives through its cycles, and shows something in each.
  void show(int cycles) {
    auto vehicle =
        ConnectedVehicle::connect(connection, cart(), {robot.wire, robot.clock, robot, robot.noting()});
    ASSERT_TRUE(vehicle.ok()) << to_string(vehicle.problems().front());
    RobotViewer viewer(robot.wire, connection, **vehicle, &watcher, robot.noting());
    const SessionTopic decision{"/decision", ros::String::kType};
    for (int i = 0; i < cycles; ++i) {
      const auto observation = (*vehicle)->sense();
      ASSERT_TRUE(observation);
      for (int messages = 0; messages < 3; ++messages)
        viewer.take(decision, static_cast<ros::Stamp_ns>(observation->stamp_s * 1e9),
                    cdr_bytes(ros::String{}));
    }
  }

  ScriptedRobot robot;
  Connection connection = plain_connection();
  BatteryWatcher watcher;
};

TEST_F(RobotViewerTest, PassesTheBatterysChargeOnEveryTwoSeconds) {
  connection.battery.topic = "battery";
  robot.script = [this] { say_charge(0.76F); };
  show(41);
  EXPECT_THAT(watcher.said, ElementsAre(R"({"charge":0.760})", R"({"charge":0.760})", R"({"charge":0.760})"));
}

TEST_F(RobotViewerTest, WhatTheBatteryWasLongAgoIsNotPassedOn) {
  connection.battery.topic = "battery";
  bool has_said = false;
  robot.script = [&] {
    if (!std::exchange(has_said, true)) say_charge(0.5F);
  };
  show(900);
  EXPECT_GE(watcher.said.size(), 25U);
  EXPECT_LE(watcher.said.size(), 31U) << "for a minute, of one and a half";
}

TEST_F(RobotViewerTest, OfABatteryThatNobodySpeaksOfItSaysNothing) {
  connection.battery.topic = "battery";
  robot.script = [this] { say_charge(NAN); };
  show(5);
  EXPECT_THAT(watcher.said, IsEmpty());
}

}  // namespace
}  // namespace aisle
