#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include "aisle/guidance/image_monitor.hpp"

namespace aisle {
namespace {

constexpr double kImageCycle_s = 0.1;

/// A vehicle with one camera, and what it reports cycle by cycle.
class ImageMonitorTest : public testing::Test {
 protected:
  ImageMonitorTest() { vehicle.cameras = {CameraDescription{.width_px = 8, .height_px = 6}}; }

  /// One cycle with an image of one grey. @return whether it is trusted
  bool is_trusted(int grey, const FrontSteeredMotion& motion, double latency_s = 0) {
    stamp_s += kImageCycle_s;
    auto image = std::make_shared<Image>(8, 6);
    std::fill(image->bytes.begin(), image->bytes.end(), static_cast<std::uint8_t>(grey));
    const Observation observation{
        .stamp_s = stamp_s, .images = {{"front", stamp_s - latency_s, image}}, .odometry = motion};
    odometry_.move(observation);
    return monitor().look(observation, odometry_) != nullptr;
  }
  std::string trouble() { return monitor().trouble(stamp_s).value_or(""); }
  ImageMonitor& monitor() {
    if (!monitor_) monitor_.emplace(ImageMonitorParams{}, vehicle.cameras.front());
    return *monitor_;
  }

  static constexpr FrontSteeredMotion kStands{};
  static constexpr FrontSteeredMotion kDrives{.distance_m = 0.03};
  VehicleDescription vehicle;
  double stamp_s = 0;

 private:
  OdometryHistory odometry_{vehicle};
  std::optional<ImageMonitor> monitor_;
};

TEST_F(ImageMonitorTest, EqualImagesOfAVehicleThatStandsAreTrusted) {
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(is_trusted(120, kStands));
  EXPECT_EQ(trouble(), "");
}

TEST_F(ImageMonitorTest, ACameraThatDoesNotSeeTheVehicleMoveIsFrozenUntilItShowsSomethingElse) {
  EXPECT_TRUE(is_trusted(120, kDrives));
  for (int i = 0; i < 6; ++i) EXPECT_FALSE(is_trusted(120, kDrives));
  EXPECT_EQ(trouble(), "camera front is frozen");
  for (int i = 0; i < 20; ++i) EXPECT_FALSE(is_trusted(120, kStands)) << "it has stopped because of that";
  EXPECT_EQ(trouble(), "camera front is frozen");
  EXPECT_TRUE(is_trusted(121, kStands));
  EXPECT_EQ(trouble(), "");
}

TEST_F(ImageMonitorTest, SlowMotionAddsUp) {
  EXPECT_TRUE(is_trusted(120, kStands));
  bool is_trusted_still = true;
  for (int i = 0; i < 30; ++i) is_trusted_still = is_trusted(120, {.distance_m = 0.001});
  EXPECT_FALSE(is_trusted_still);
}

TEST_F(ImageMonitorTest, AVehicleThatRocksOnTheSpotHasNotMoved) {
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(is_trusted(120, {.distance_m = i % 2 == 0 ? 0.005 : -0.005}));
}

TEST_F(ImageMonitorTest, ALateImageFromBeforeTheVehicleMovedIsNotFrozen) {
  constexpr double kLatency_s = 0.25;
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(is_trusted(120, kStands, kLatency_s));
  for (int i = 0; i < 2; ++i) EXPECT_TRUE(is_trusted(120, kDrives, kLatency_s));
  for (int grey = 121; grey < 130; ++grey) EXPECT_TRUE(is_trusted(grey, kDrives, kLatency_s));
}

}  // namespace
}  // namespace aisle
