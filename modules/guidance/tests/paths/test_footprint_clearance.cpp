#include "aisle/guidance/paths/footprint_clearance.hpp"

#include <gtest/gtest.h>

#include "aisle/core/random.hpp"
#include "free_floor.hpp"

namespace aisle {
namespace {

constexpr double kKept_m = 0.05;
constexpr FloorCell kPost{60, 60};

KnownFloor hall_with_post() {
  KnownFloor hall = free_floor({{Vec2(0, 0), Vec2(6, 6)}});
  occupy(hall, kPost);
  return hall;
}

Pose2 about_the_post(Random& random) {
  const double x_m = random.uniform(1.5, 4.5), y_m = random.uniform(1.5, 4.5);
  return {x_m, y_m, random.uniform(-kPi, kPi)};
}

TEST(FootprintClearance, ItsEndsMayComeAsNearAsItsSides) {
  const KnownFloor hall = free_floor({{Vec2(0, 0), Vec2(10, 4)}});
  const FootprintClearance footprint_clearance(cart().footprint, kKept_m);
  const auto fits = [&](const Pose2& T) { return footprint_clearance.fits(hall, T); };
  EXPECT_TRUE(fits({8.97, 2, 0}));
  EXPECT_FALSE(fits({9.01, 2, 0}));
  EXPECT_TRUE(fits({0.33, 2, 0}));
  EXPECT_FALSE(fits({0.29, 2, 0}));
  EXPECT_TRUE(fits({5, 0.375, 0}));
  EXPECT_FALSE(fits({5, 0.345, 0}));
}

/// So a search may check a few poses of an arc only.
TEST(FootprintClearance, ChangesLittleWhileAPostIsPassed) {
  const KnownFloor hall = hall_with_post();
  const FootprintClearance footprint_clearance(cart().footprint, kKept_m);
  double least_m = 1, most_m = 0;
  for (double along_m = 0; along_m < 0.7; along_m += 0.01) {
    const double clearance_m = footprint_clearance.clearance_m(hall, {3 - along_m, 3.5, 0});
    least_m = std::min(least_m, clearance_m);
    most_m = std::max(most_m, clearance_m);
  }
  EXPECT_GT(least_m, 0.08);
  EXPECT_LT(most_m - least_m, 0.01);
}

TEST(FootprintClearance, MeasuresEnoughClearanceExactly) {
  const KnownFloor hall = hall_with_post();
  const FootprintClearance footprint_clearance(cart().footprint, kKept_m);
  Random random(1);
  int enough = 0, too_little = 0;
  for (int i = 0; i < 5000; ++i) {
    const Pose2 T_map_vehicle{random.uniform(-1, 7), random.uniform(-1, 7), random.uniform(-kPi, kPi)};
    const double enough_m = random.uniform(-0.1, 0.3);
    const double exact_m = footprint_clearance.clearance_m(hall, T_map_vehicle);
    const double needed_m = footprint_clearance.clearance_m(hall, T_map_vehicle, enough_m);
    ++(exact_m >= enough_m ? enough : too_little);
    if (exact_m >= enough_m)
      EXPECT_EQ(needed_m, exact_m);
    else
      EXPECT_LT(needed_m, enough_m);
  }
  EXPECT_GT(enough, 1000);
  EXPECT_GT(too_little, 1000);
}

/// Unseen floor, such as beside a door's jamb while it is passed, may hide a wall.
TEST(FootprintClearance, FitsBarelyNoNearerToTheUnseenThanWhereItStands) {
  const KnownFloor strip = free_floor({{Vec2(0, 0), Vec2(6, 1)}});
  const FootprintClearance footprint_clearance(cart().footprint, kKept_m);
  const auto fits_from = [&](double y_now_m, double y_later_m) {
    const Pose2 T_map_now{2, y_now_m, 0}, T_map_later{2.2, y_later_m, 0};
    const RelaxedClearance now = footprint_clearance.relaxed_clearance(strip, T_map_now);
    return footprint_clearance.fits_barely(strip, T_map_later, now);
  };
  EXPECT_TRUE(fits_from(0.32, 0.32));  // 2 cm from it now, and later
  EXPECT_TRUE(fits_from(0.32, 0.33));
  EXPECT_FALSE(fits_from(0.32, 0.31));
  EXPECT_FALSE(fits_from(0.5, 0.32));
  EXPECT_TRUE(fits_from(0.5, 0.37));
}

TEST(FootprintClearance, CoversTheWholeFootprint) {
  const KnownFloor hall = hall_with_post();
  const Footprint footprint = cart().footprint;
  const FootprintClearance footprint_clearance(footprint, 0);
  Random random(1);
  int fitting = 0;
  for (int i = 0; i < 5000; ++i) {
    const Pose2 T_map_vehicle = about_the_post(random);
    if (!footprint_clearance.fits(hall, T_map_vehicle)) continue;
    ++fitting;
    const Vec2 p_vehicle = T_map_vehicle.inverse() * hall.grid().centre(kPost);
    EXPECT_GT(off_footprint_m(footprint, p_vehicle), 0);
  }
  EXPECT_GT(fitting, 2000);
}

TEST(FootprintClearance, LiesOnFreeFloorIfNoObstacleIsUnderIt) {
  const KnownFloor hall = hall_with_post();
  const Footprint footprint = cart().footprint;
  const FootprintClearance footprint_clearance(footprint, 0);
  const double cell_m = hall.grid().cell_m();
  Random random(2);
  int on_it = 0, off_it = 0;
  for (int i = 0; i < 5000; ++i) {
    const Pose2 T_map_vehicle = about_the_post(random);
    const double off_m = off_footprint_m(footprint, T_map_vehicle.inverse() * hall.grid().centre(kPost));
    if (std::abs(off_m) < cell_m) continue;
    ++(off_m < 0 ? on_it : off_it);
    EXPECT_EQ(footprint_clearance.lies_on_free(hall, T_map_vehicle), off_m > 0);
  }
  EXPECT_GT(on_it, 150);
  EXPECT_GT(off_it, 2000);
}

}  // namespace
}  // namespace aisle
