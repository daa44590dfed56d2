#include <gmock/gmock.h>

#include <filesystem>

#include "aisle/formats/worlds/world_yaml.hpp"
#include "aisle/simulation/cross_section.hpp"
#include "aisle/simulation/operators/tour_driver.hpp"
#include "aisle/simulation/paths/free_floor.hpp"
#include "aisle/simulation/wall_grid.hpp"

namespace aisle {
namespace {

constexpr double kVehicleRadius_m = 0.3;
constexpr double kVehicleHeight_m = 1.3;

std::vector<std::filesystem::path> shipped_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(AISLE_SOURCE_DIR "/worlds")) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

class ShippedWorld : public testing::TestWithParam<std::filesystem::path> {
 protected:
  void SetUp() override {
    Result<World> read = read_world(GetParam());
    ASSERT_TRUE(read.ok()) << to_string(read.problems());
    world_ = std::move(*read);
    obstacles_ = obstacles_below(world_, kVehicleHeight_m);
  }

  World world_;
  std::vector<Segment2> obstacles_;
};

TEST_P(ShippedWorld, IsCalledAsItsFileAndHasAllThatAMissionNeeds) {
  EXPECT_EQ(world_.name, GetParam().stem());
  EXPECT_TRUE(world_.start.has_value());
  EXPECT_GE(world_.places.size() + world_.parking_frames.size(), 3u);
  EXPECT_GE(world_.tour.size(), 3u);
  EXPECT_GE(world_.lamps.size(), 5u);
  EXPECT_GE(world_.posters.size(), 5u);
}

TEST_P(ShippedWorld, AVehicleGetsFromTheStartToEveryPlace) {
  const FreeFloor floor(obstacles_, world_.start->position(), kVehicleRadius_m);
  EXPECT_GT(floor.area_m2(), 5);
  EXPECT_LT(floor.area_m2(), 2000) << "the floor must not lead out of the building";
  for (const NamedPlace& place : world_.places) {
    EXPECT_TRUE(floor.reaches(place.T_world_place.position())) << place.name;
  }
  for (const ParkingFrame& frame : world_.parking_frames) {
    EXPECT_TRUE(floor.reaches(frame.centre)) << frame.name;
  }
  for (const Vec2& p : world_.tour) EXPECT_TRUE(floor.reaches(p)) << p.transpose();
}

TEST_P(ShippedWorld, TheTourIsDrivenWithoutTouchingAnything) {
  EXPECT_GE(clearance_m(world_.tour, obstacles_), kVehicleRadius_m);
  TourDriver driver(world_.tour, {});
  std::vector<Vec2> driven = {driver.pose().position()};
  while (!driver.has_arrived()) {
    driver.step(0.1);
    if ((driver.pose().position() - driven.back()).norm() > 0.2) driven.push_back(driver.pose().position());
  }
  EXPECT_GE(clearance_m(driven, obstacles_), kVehicleRadius_m);
}

TEST_P(ShippedWorld, PostersHangWhereTheyAreSeen) {
  for (const Poster& poster : world_.posters) {
    const WallGrid grid(cross_section(world_, poster.bottom_m + poster.height_m / 2));
    const Vec2 ahead = unit(poster.facing_rad);
    EXPECT_GT(grid.cast(poster.centre + 0.05 * ahead, ahead), 0.5) << poster.centre.transpose();
    const Vec2 edge = (poster.width_m / 2 - 0.01) * left_normal(ahead);
    for (const Vec2& p : {Vec2(poster.centre - edge), Vec2(poster.centre + edge)}) {
      EXPECT_LT(grid.cast(p + 0.1 * ahead, -ahead), 0.14)
          << "hangs beside its wall or over a door: " << p.transpose();
    }
  }
}

TEST_P(ShippedWorld, PeopleWalkThroughNoWalls) {
  for (const Person& person : world_.people) {
    EXPECT_GE(clearance_m(person.path, obstacles_), person.radius_m) << person.path[0].transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(Worlds, ShippedWorld, testing::ValuesIn(shipped_files()), [](const auto& world) {
  std::string name = world.param.stem();
  std::erase(name, '-');
  return name;
});

TEST(ShippedWorlds, RangeFromOneCornerToTwoLoops) {
  EXPECT_THAT(shipped_files(), testing::SizeIs(testing::Ge(8)));
}

}  // namespace
}  // namespace aisle
