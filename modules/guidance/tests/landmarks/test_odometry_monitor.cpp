#include "aisle/guidance/landmarks/odometry_monitor.hpp"

#include <gmock/gmock.h>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"

namespace aisle {
namespace {

using testing::DoubleNear;
using testing::Eq;
using testing::Optional;

/// Drives on for some metres. The map's poses jitter by 2 cm.
class Driven {
 public:
  void drive(double path_m, double counted_per_m, double turn_per_m = 0) {
    for (double to_m = true_m_ + path_m; true_m_ < to_m; true_m_ += kStep_m) {
      T_map_vehicle_ = T_map_vehicle_ * Pose2{kStep_m, 0, turn_per_m * kStep_m};
      T_odom_vehicle_ = T_odom_vehicle_ * Pose2{kStep_m * counted_per_m, 0, turn_per_m * kStep_m};
      monitor.look(T_odom_vehicle_, T_map_vehicle_ * Pose2{random_.normal(0.02), random_.normal(0.02), 0});
    }
  }

  void drive_blind(double path_m, double counted_per_m) {
    true_m_ += path_m;
    T_map_vehicle_ = T_map_vehicle_ * Pose2{path_m, 0, 0};
    T_odom_vehicle_ = T_odom_vehicle_ * Pose2{path_m * counted_per_m, 0, 0};
  }
  void lift(const Pose2& T_before_after) {
    T_map_vehicle_ = T_map_vehicle_ * T_before_after;
    monitor.relocalise(T_odom_vehicle_, T_map_vehicle_);
  }

  OdometryMonitor monitor;

 private:
  static constexpr double kStep_m = 0.04;
  double true_m_ = 0;
  Pose2 T_map_vehicle_{3, 2, 0.5}, T_odom_vehicle_;
  Random random_{3};
};

TEST(OdometryMonitor, LeavesPercentsAndShortSlipsToTheLocaliser) {
  Driven driven;
  driven.drive(10, 1.05);
  EXPECT_THAT(driven.monitor.off_by(), Eq(std::nullopt));
  driven.drive(0.8, 1.5);
  EXPECT_THAT(driven.monitor.off_by(), Eq(std::nullopt));
  driven.drive(3, 1, 60 * kDegree);
  EXPECT_THAT(driven.monitor.off_by(), Eq(std::nullopt));
}

TEST(OdometryMonitor, NoticesWheelsThatCountTwiceOrHalfWithinTwoMetres) {
  for (const double counted_per_m : {2.0, 0.5}) {
    Driven driven;
    driven.drive(5, 1);
    driven.drive(2.5, counted_per_m);
    EXPECT_THAT(driven.monitor.off_by(), Optional(DoubleNear(counted_per_m, 0.35))) << counted_per_m;
  }
}

TEST(OdometryMonitor, NoticesWheelsThatSpinWhileTheVehicleStands) {
  Driven driven;
  driven.drive(2, 1);
  driven.drive(0.4, 10);
  EXPECT_TRUE(driven.monitor.off_by().has_value());
}

TEST(OdometryMonitor, BeginsAnewWhereTheVehicleWasLifted) {
  Driven driven;
  driven.drive(5, 1);
  driven.lift({0.9, 0, 0});
  driven.drive(5, 1);
  driven.lift({-6, 1, 0});
  driven.drive(5, 1);
  EXPECT_THAT(driven.monitor.off_by(), Eq(std::nullopt));
}

TEST(OdometryMonitor, ComparesAcrossAPathOnWhichNothingMatched) {
  Driven driven;
  driven.drive(2, 1);
  driven.drive_blind(1.5, 0.5);
  driven.drive(0.1, 0.5);
  EXPECT_THAT(driven.monitor.off_by(), Optional(DoubleNear(0.55, 0.1)));
}

}  // namespace
}  // namespace aisle
