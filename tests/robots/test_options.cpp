#include <gmock/gmock.h>

#include "mujoco/options.hpp"

namespace robots {
namespace {

Options parsed(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "mujoco_robot");
  return parse_options(static_cast<int>(arguments.size()), arguments.data()).value();
}

std::string refusal(const std::vector<const char*>& arguments) {
  try {
    parsed(arguments);
    return "";
  } catch (const UsageError& error) {
    return error.what();
  }
}

TEST(RobotOptions, AreRead) {
  const Options options =
      parsed({"--world", "w.yaml", "--start", "1,-2.5,90", "--camera", "320x240", "--slip"});
  EXPECT_EQ(options.world, "w.yaml");
  EXPECT_DOUBLE_EQ(options.T_world_start->y, -2.5);
  EXPECT_EQ(options.camera->height_px, 240);
  EXPECT_TRUE(options.slip);
}

TEST(RobotOptions, ThatCannotBeAreRefusedWithTheirName) {
  EXPECT_EQ(refusal({"--world", "w", "--sideways"}), "unknown option '--sideways'; --help lists them");
  EXPECT_EQ(refusal({"--world", "w", "--domain", "102"}),
            "--domain: '102' is not a whole number from 0 to 101");
  EXPECT_EQ(refusal({"--world", "w", "--drive", "tracks"}),
            "--drive: 'tracks' is not differential or front-steered");
  EXPECT_EQ(refusal({"--world", "w", "--start", "1,2"}), "--start: '1,2' is not X,Y,DEG");
  EXPECT_EQ(refusal({"--world"}), "--world needs a value");
  EXPECT_EQ(refusal({}), "--world is needed");
}

TEST(RobotOptions, ThatContradictEachOtherAreRefused) {
  EXPECT_EQ(refusal({"--world", "w", "--speed", "5"}), "--speed needs --clock");
  EXPECT_EQ(refusal({"--world", "w", "--command", "ackermann"}),
            "--command ackermann needs --drive front-steered");
}

}  // namespace
}  // namespace robots
