#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "mujoco/world.hpp"

namespace robots {
namespace {

using testing::ElementsAre;

class WorldFile : public testing::Test {
 protected:
  static World read_text(const std::string& text) {
    const std::string path = testing::TempDir() + "robots_world_" + std::to_string(getpid()) + ".yaml";
    std::ofstream(path) << "format: aisle.world\nversion: 1\n" << text;
    return read_world(path);
  }
};

TEST_F(WorldFile, OfTheLCorridorHasItsWallsDoorsAndStart) {
  const World world = read_world(AISLE_SOURCE_DIR "/worlds/l-corridor.yaml");
  // Six walls and nine closed doors.
  EXPECT_EQ(std::count_if(world.solids.begin(), world.solids.end(),
                          [](const Solid& solid) { return solid.is_obstacle; }),
            6 + 9);
  EXPECT_DOUBLE_EQ(world.T_world_start.x, 1.2);
  EXPECT_DOUBLE_EQ(world.T_world_start.y, 1.05);
  EXPECT_DOUBLE_EQ(world.T_world_start.heading_rad, 0);
  EXPECT_THAT(world.left_out, testing::IsEmpty());
}

TEST_F(WorldFile, WallsLieBehindTheirFreeSide) {
  // The free side of a wall towards x is on its left, at greater y.
  const World world = read_text("walls: [[[0, 1], [4, 1]]]");
  ASSERT_EQ(world.solids.size(), 2u);
  const Solid& wall = world.solids[0];
  EXPECT_DOUBLE_EQ(wall.length_m, 4);
  EXPECT_DOUBLE_EQ(wall.T_world_centre.x, 2);
  EXPECT_DOUBLE_EQ(wall.T_world_centre.y + wall.width_m / 2, 1);
  EXPECT_DOUBLE_EQ(wall.top_m, 2.7);
}

TEST_F(WorldFile, ASkirtingBoardIsSeenAtTheFootOfAWall) {
  const Solid board = read_text("walls: [[[0, 1], [4, 1]]]").solids.at(1);
  EXPECT_FALSE(board.is_obstacle);
  EXPECT_DOUBLE_EQ(board.top_m, 0.1);
  EXPECT_GT(board.T_world_centre.y + board.width_m / 2, 1) << "in front of the wall's face";
  EXPECT_EQ(read_text("skirting_height_m: 0\nwalls: [[[0, 1], [4, 1]]]").solids.size(), 1u);
}

TEST_F(WorldFile, AnOpenDoorStandsWhereItIsTurned) {
  const World world =
      read_text("doors: [{hinge: [1, 2], closed_heading_deg: 0, open_deg: 90, frame_width_m: 0}]");
  ASSERT_EQ(world.solids.size(), 1u);
  EXPECT_NEAR(world.solids[0].T_world_centre.x, 1, 1e-9);
  EXPECT_NEAR(world.solids[0].T_world_centre.y, 2.45, 1e-9);
}

TEST_F(WorldFile, ATableStandsOnFourLegs) {
  const World world = read_text("furniture: [{kind: table, centre: [0, 0], size: [2, 1]}]");
  EXPECT_EQ(std::count_if(world.solids.begin(), world.solids.end(),
                          [](const Solid& solid) { return solid.bottom_m == 0; }),
            4);
  EXPECT_EQ(world.solids.size(), 5u);
}

TEST_F(WorldFile, WhatIsNotBuiltIsNamed) {
  EXPECT_THAT(read_text("people: [{path: [[0, 0], [1, 0]]}]\nlamps: []").left_out, ElementsAre("people"));
}

TEST_F(WorldFile, WithoutAStartBeginsAtTheTour) {
  const Pose2 T_world_start = read_text("tour: [[3, 4], [3, 9]]").T_world_start;
  EXPECT_DOUBLE_EQ(T_world_start.x, 3);
  EXPECT_DOUBLE_EQ(to_degrees(T_world_start.heading_rad), 90);
}

TEST_F(WorldFile, ThatIsNoneIsRefused) {
  EXPECT_THROW(read_world("/none.yaml"), std::runtime_error);
  EXPECT_THROW(read_text("walls: [[[0, north], [4, 1]]]"), std::runtime_error);
}

}  // namespace
}  // namespace robots
