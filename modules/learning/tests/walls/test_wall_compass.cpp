#include "aisle/learning/walls/wall_compass.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kSure_rad = 0.1 * kDegree, kUnsure_rad = 2 * kDegree;

SensedSegment edge(double heading_rad) {
  SensedSegment edge;
  edge.heading_rad = wrap_angle(heading_rad);
  edge.length_m = 2;
  edge.sigma_heading_rad = 0.3 * kDegree;
  return edge;
}

/// Both sides of a corridor in this direction on the map, and its end.
std::vector<SensedSegment> corridor(double walls_rad, double heading_rad) {
  return {edge(walls_rad - heading_rad), edge(walls_rad - heading_rad + kPi),
          edge(walls_rad - heading_rad + kPi / 2)};
}

/// Takes an image from far enough on that its edges have other errors.
void look_again(WallCompass& compass, const std::vector<SensedSegment>& edges, double heading_rad,
                double sigma_rad) {
  compass.move(0.5, 0);
  compass.look(edges, heading_rad, sigma_rad);
}

/// A compass that saw this many images of such a corridor.
WallCompass compass_in(double walls_rad, int images = 20) {
  WallCompass compass;
  for (int i = 0; i < images; ++i) {
    look_again(compass, corridor(walls_rad, 0.3), 0.3, kSure_rad);
    compass.learn(0.3, kSure_rad);
  }
  return compass;
}

TEST(WallCompass, GivesTheHeadingByWallsSeenWhereItWasKnown) {
  for (const double walls_rad : {-0.7, 0.0, 0.4, 3.1}) {
    WallCompass compass = compass_in(walls_rad);
    for (const double heading_rad : {0.3, 0.3 + kPi / 2, -3.0}) {
      look_again(compass, corridor(walls_rad, heading_rad), heading_rad + 3 * kDegree, kUnsure_rad);
      ASSERT_TRUE(compass.heading()) << walls_rad;
      EXPECT_NEAR(wrap_angle(compass.heading()->heading_rad - heading_rad), 0, 0.1 * kDegree) << walls_rad;
    }
  }
}

TEST(WallCompass, SaysNothingWhereTheHeadingIsSurer) {
  WallCompass compass = compass_in(0);
  look_again(compass, corridor(0, 0), 0, kUnsure_rad);
  EXPECT_TRUE(compass.heading());
  look_again(compass, corridor(0, 0), 0, 0.05 * kDegree);
  EXPECT_FALSE(compass.heading());
  look_again(compass, {}, 0, kUnsure_rad);
  EXPECT_FALSE(compass.heading()) << "no wall in view";
}

TEST(WallCompass, ALongPathMakesItLessSure) {
  WallCompass compass = compass_in(0);
  look_again(compass, corridor(0, 0), 0, kUnsure_rad);
  const double before_rad = compass.heading()->sigma_rad;
  compass.move(50, 0);
  look_again(compass, corridor(0, 0), 0, kUnsure_rad);
  EXPECT_GT(compass.heading()->sigma_rad, before_rad);
}

TEST(WallCompass, ImagesInARowCountLessTheNearerTheyAre) {
  const auto sigma_after_rad = [](double path_m, double turn_rad) {
    WallCompass compass = compass_in(0);
    compass.move(path_m, turn_rad);
    compass.look(corridor(0, 0), 0, kUnsure_rad);
    return compass.heading() ? compass.heading()->sigma_rad : kPi;
  };
  EXPECT_LT(sigma_after_rad(0.3, 0), sigma_after_rad(0.03, 0) / 2);
  EXPECT_LT(sigma_after_rad(0, 10 * kDegree), sigma_after_rad(0, 1 * kDegree) / 2);
  EXPECT_EQ(sigma_after_rad(0, 0), kPi) << "standing, it sees the same again";
}

TEST(WallCompass, AnOpenDoorHardlyChangesIt) {
  WallCompass compass = compass_in(0);
  std::vector<SensedSegment> seen = corridor(0, 0);
  seen.push_back(edge(20 * kDegree));
  look_again(compass, seen, 0, kUnsure_rad);
  ASSERT_TRUE(compass.heading());
  EXPECT_NEAR(compass.heading()->heading_rad, 0, 0.3 * kDegree);
}

TEST(WallCompass, WallsInAnotherDirectionForLongBecomeTheKnownOnes) {
  constexpr double kOblique_rad = 30 * kDegree;
  WallCompass compass = compass_in(0);
  look_again(compass, corridor(kOblique_rad, 0), 0, kUnsure_rad);
  EXPECT_FALSE(compass.heading()) << "these are no walls that it knows";
  for (int i = 0; i < 100; ++i) {
    look_again(compass, corridor(kOblique_rad, 0), 0, kSure_rad);
    compass.learn(0, kSure_rad);
  }
  EXPECT_EQ(compass.starts(), 2);
  look_again(compass, corridor(kOblique_rad, 0), 1 * kDegree, kUnsure_rad);
  ASSERT_TRUE(compass.heading());
  EXPECT_NEAR(compass.heading()->heading_rad, 0, 0.2 * kDegree);
}

TEST(WallCompass, WallsKnownFromTheStartGiveTheHeadingInTheFirstImage) {
  for (const double quarter_turns : {0, 1, 2, 3}) {
    const double heading_rad = wrap_angle(0.4 + quarter_turns * kPi / 2);
    WallCompass compass;
    compass.start(WallDirection{.direction_rad = 0.4, .sigma_rad = 0.2 * kDegree});
    compass.look(corridor(0.4, heading_rad), heading_rad + 3 * kDegree, kUnsure_rad);
    ASSERT_TRUE(compass.heading()) << quarter_turns;
    EXPECT_NEAR(wrap_angle(compass.heading()->heading_rad - heading_rad), 0, 0.1 * kDegree) << quarter_turns;
  }
}

TEST(WallCompass, AfterARestartNothingIsKnown) {
  WallCompass compass = compass_in(0);
  compass.start();
  EXPECT_EQ(compass.starts(), 0);
  EXPECT_FALSE(compass.heading());
}

}  // namespace
}  // namespace aisle
