#include "aisle/localisation/surface_field.hpp"

#include <gtest/gtest.h>

#include "hand_building.hpp"

namespace aisle {
namespace {

TEST(SurfaceField, KnowsTheDistanceToTheNearestWall) {
  const Building building = hand::l_room();
  const SurfaceField field(building);
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const Vec2 p(random.uniform(-0.9, 12.9), random.uniform(-0.9, 8.9));
    double nearest_m = SurfaceField::kFar_m;
    for (const Wall& wall : building.walls.walls) nearest_m = std::min(nearest_m, wall.segment.distance(p));
    EXPECT_NEAR(field.distance_m(p), nearest_m, 0.04) << p.transpose();
  }
}

TEST(SurfaceField, TakesOccupiedFloorThatNoWallExplains) {
  Building building = hand::bare_room();
  building.floor = FloorGrid(0.05);
  for (int x = 0; x < 200; ++x) {
    for (int y = 0; y < 120; ++y) building.floor->set({x, y}, Floor::kFree);
  }
  building.floor->set(building.floor->cell_at(Vec2(4, 3)), Floor::kOccupied);
  building.floor->set(building.floor->cell_at(Vec2(4, 0.02)), Floor::kOccupied);
  const SurfaceField field(building);
  ASSERT_NE(field.nearest({4.1, 3}), nullptr);
  EXPECT_FALSE(field.nearest({4.1, 3})->is_wall());
  EXPECT_TRUE(field.nearest({4, 0.1})->is_wall()) << "the cell at the wall is the wall";
  EXPECT_TRUE(field.can_stand({5, 5}));
  EXPECT_FALSE(field.can_stand({5, 6.5})) << "beyond the wall nobody has seen the floor";
}

TEST(SurfaceField, RefusesABuildingWithoutSurfaces) {
  EXPECT_THROW(SurfaceField{Building{}}, std::invalid_argument);
}

}  // namespace
}  // namespace aisle
