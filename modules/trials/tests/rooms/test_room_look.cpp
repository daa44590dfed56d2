#include <gtest/gtest.h>

#include "rooms/room_look.hpp"

namespace aisle {
namespace {

World furnished() {
  World world;
  world.ambient_light = 0.4;
  world.floor = {.kind = FloorCovering::Kind::kPlain, .brightness = 0.6, .contrast = 0.04};
  world.furniture = {{.brightness = 0.2}, {.brightness = 0.8}};
  return world;
}

TEST(RoomLook, LeavesTheWorldAsItIsUnlessAsked) {
  World world = furnished();
  RoomLook{}.apply(world);
  EXPECT_DOUBLE_EQ(world.ambient_light, 0.4);
  EXPECT_EQ(world.floor.kind, FloorCovering::Kind::kPlain);
  EXPECT_DOUBLE_EQ(world.floor.contrast, 0.04);
  EXPECT_DOUBLE_EQ(world.furniture[0].brightness, 0.2);
}

TEST(RoomLook, FurnitureComesNearTheFloorsBrightnessFromBothSides) {
  World world = furnished();
  RoomLook{.ambient_share = 0.5, .floor_contrast = 0.3, .floor_gloss = 0.6, .like_floor_share = 0.5}.apply(
      world);
  EXPECT_DOUBLE_EQ(world.ambient_light, 0.2);
  EXPECT_EQ(world.floor.kind, FloorCovering::Kind::kCarpet);
  EXPECT_DOUBLE_EQ(world.floor.contrast, 0.3);
  EXPECT_DOUBLE_EQ(world.floor.gloss, 0.6);
  EXPECT_DOUBLE_EQ(world.furniture[0].brightness, 0.4);
  EXPECT_DOUBLE_EQ(world.furniture[1].brightness, 0.7);
}

}  // namespace
}  // namespace aisle
