#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "aisle/core/random.hpp"
#include "aisle/simulation/operators/tour_driver.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

constexpr double kStep_s = 0.02;

TEST(TourDriver, CutsACornerByLessThanItsLookAhead) {
  TourDriver driver({{0, 0}, {4, 0}, {4, 4}}, {});
  double nearest_to_corner_m = 9;
  while (!driver.has_arrived()) {
    driver.step(kStep_s);
    nearest_to_corner_m = std::min(nearest_to_corner_m, (driver.pose().position() - Vec2(4, 0)).norm());
  }
  EXPECT_THAT(driver.pose(), PoseNear(Pose2{4, 4, kPi / 2}, 0.06, 5 * kDegree));
  EXPECT_GT(nearest_to_corner_m, 0.02);
  EXPECT_LT(nearest_to_corner_m, 0.5);
}

TEST(TourDriver, TurnsRoundInLittleSpaceWhereTheTourTurnsBack) {
  TourDriver driver({{0, 0}, {3, 0}, {0, 0}}, {});
  double widest_m = 0;
  while (!driver.has_arrived()) {
    driver.step(kStep_s);
    widest_m = std::max(widest_m, std::abs(driver.pose().y));
  }
  EXPECT_LT(widest_m, 0.25);
  EXPECT_THAT(driver.pose(), PoseNear(Pose2{0, 0, kPi}, 0.06, 5 * kDegree));
}

TEST(TourDriver, RefusesATourThatLeadsNowhere) {
  EXPECT_THROW(TourDriver({{1, 1}, {1, 1}}, {}), std::invalid_argument);
  EXPECT_THROW(TourDriver({}, {}), std::invalid_argument);
}

RC_GTEST_PROP(TourDriver, ArrivesWithinItsLimits, (std::uint64_t seed)) {
  Random random(seed);
  std::vector<Vec2> tour(2 + random.index(8));
  for (Vec2& point : tour) point = {random.uniform(-5, 5), random.uniform(-5, 5)};
  TourDriverParams params;
  params.turn_rate_max_rad_s = random.uniform(5, 180) * kDegree;
  params.look_ahead_m = random.uniform(0.1, 2);
  params.acceleration_max_mps2 = random.uniform(0.05, 5);
  TourDriver driver(tour, params);
  for (int i = 0; i < 60'000 && !driver.has_arrived(); ++i) {
    const Arc arc = driver.step(kStep_s);
    RC_ASSERT(arc.length_m >= 0 && arc.length_m <= params.speed_max_mps * kStep_s * (1 + 1e-9));
    RC_ASSERT(std::abs(arc.turn_rad) <= params.turn_rate_max_rad_s * kStep_s * (1 + 1e-9));
  }
  RC_ASSERT(driver.has_arrived());
}

}  // namespace
}  // namespace aisle
