#include <gtest/gtest.h>

#include "aisle/simulation/scenario_play.hpp"
#include "aisle/simulation/vehicle/camera_feed.hpp"

namespace aisle {
namespace {

using Kind = CameraFault::Kind;

TEST(ScenarioPlay, AnEventLastsFromItsTimeOn) {
  ScenarioPlay play({.events = {{.fault = SlipBurst{.spin = 2}, .from_s = 3, .duration_s = 2}}});
  for (const auto& [now_s, spin] : {std::pair{2.9, 0.0}, {3.0, 2.0}, {4.9, 2.0}, {5.0, 0.0}}) {
    play.advance(now_s, {0, 0});
    EXPECT_EQ(play.spin(), spin) << now_s;
  }
}

TEST(ScenarioPlay, AnEventAtAPlaceWaitsForTheVehicleAndThenLasts) {
  ScenarioPlay play(
      {.events = {{.fault = LaserOff{}, .from_s = 1, .near = Vec2(5, 0), .radius_m = 0.5, .duration_s = 2}}});
  play.advance(0.5, {5, 0});  // too early
  EXPECT_TRUE(play.laser_is_on());
  play.advance(2, {4.4, 0});
  EXPECT_TRUE(play.laser_is_on());
  play.advance(3, {4.6, 0});
  EXPECT_FALSE(play.laser_is_on());
  play.advance(4.9, {9, 0});
  EXPECT_FALSE(play.laser_is_on());
  play.advance(5.1, {5, 0});  // once only
  EXPECT_TRUE(play.laser_is_on());
}

TEST(ScenarioPlay, FaultsOfOneKindAddUp) {
  ScenarioPlay play({.events = {{.fault = SteeringBias{0.1}},
                                {.fault = SteeringBias{0.2}},
                                {.fault = LightChange{.light = 0.5}},
                                {.fault = LightChange{.light = 0.5, .lamps_on = false}}}});
  play.advance(1, {0, 0});
  EXPECT_DOUBLE_EQ(play.steering_bias_rad(), 0.1 + 0.2);
  EXPECT_DOUBLE_EQ(play.light().light, 0.25);
  EXPECT_FALSE(play.light().lamps_on);
}

TEST(ScenarioPlay, ACameraFaultIsThatOfItsCameraOrOfAll) {
  ScenarioPlay play({.events = {{.fault = CameraFault{.kind = Kind::kFrozen, .camera = "left"}},
                                {.fault = CameraFault{.kind = Kind::kDark}}}});
  play.advance(1, {0, 0});
  EXPECT_TRUE(play.trouble_of("left").frozen);
  EXPECT_FALSE(play.trouble_of("right").frozen);
  EXPECT_TRUE(play.trouble_of("right").dark);
}

class FeedTest : public testing::Test {
 protected:
  /// An image a tenth of a second, its brightness its number.
  void take(const CameraTrouble& trouble) {
    ++taken_;
    auto image = std::make_shared<Image>(1, 1);
    image->bytes[0] = static_cast<std::uint8_t>(taken_);
    feed_.take({.camera = "front", .stamp_s = taken_ * 0.1, .pixels = image}, trouble);
  }
  /// What arrives in this cycle: "stamp:number".
  std::string arrived() {
    const auto image = feed_.deliver(taken_ * 0.1 + 1e-9);
    if (!image) return "nothing";
    return std::to_string(std::lround(image->stamp_s * 10)) + ":" + std::to_string(image->pixels->bytes[0]);
  }
  std::string next(const CameraTrouble& trouble) {
    take(trouble);
    return arrived();
  }

  CameraFeed feed_;
  int taken_ = 0;
};

TEST_F(FeedTest, AGoodCameraDeliversEachImageAtOnceAndOnce) {
  EXPECT_EQ(next({}), "1:1");
  EXPECT_EQ(arrived(), "nothing");
  EXPECT_EQ(next({}), "2:2");
}

TEST_F(FeedTest, AFrozenCameraRepeatsItsLastImageWithNewStamps) {
  next({});
  EXPECT_EQ(next({.frozen = true}), "2:1");
  EXPECT_EQ(next({.frozen = true}), "3:1");
  EXPECT_EQ(next({}), "4:4");
}

TEST_F(FeedTest, DroppedImagesNeverCome) {
  EXPECT_EQ(next({.dropped = true}), "nothing");
  EXPECT_EQ(next({}), "2:2");
}

TEST_F(FeedTest, LateImagesKeepTheirStampsAndTheirOrder) {
  EXPECT_EQ(next({.delay_s = 0.2}), "nothing");
  EXPECT_EQ(next({.delay_s = 0.2}), "nothing");
  EXPECT_EQ(next({.delay_s = 0.2}), "1:1");
  EXPECT_EQ(next({}), "2:2");  // 4 is behind 3
  EXPECT_EQ(next({}), "5:5");
}

}  // namespace
}  // namespace aisle
