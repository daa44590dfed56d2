#include "aisle/guidance/exploration/floor_learner.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "../cart.hpp"

namespace aisle {
namespace {

constexpr std::size_t kBeams = 181;
constexpr double kThinRadius_m = 0.02;

/// The cart stands in a room of 8 m by 8 m, its laser in the middle, among thin obstacles given in the
/// laser's frame.
class StandingCart {
 public:
  StandingCart() : learner_({}, scanning_cart(), scanner_scans(scanning_cart())) {}

  FloorLearner::News look(const std::vector<Vec2>& p_laser_thin) {
    Observation observation{.stamp_s = stamp_s_ += 0.1};
    std::vector<float> ranges_m(kBeams);
    for (std::size_t beam = 0; beam < kBeams; ++beam) {
      const Vec2 along = unit(kGeometry.beam_angle(beam));
      double range_m = 4 / along.cwiseAbs().maxCoeff();
      for (const Vec2& p_laser : p_laser_thin) {
        const bool is_hit = std::abs(left_normal(along).dot(p_laser)) < kThinRadius_m;
        if (is_hit && along.dot(p_laser) > 0) range_m = std::min(range_m, along.dot(p_laser));
      }
      ranges_m[beam] = static_cast<float>(range_m);
    }
    observation.scan = RangeScan{.ranges_m = std::move(ranges_m)};
    return learner_.take(observation);
  }

  Floor at(const Vec2& p_laser) const { return learner_.floor().grid().at(in_map(p_laser)); }
  /// Straight ahead, between the two distances, stands neither an obstacle nor a table.
  bool is_open(double from_m, double to_m) const {
    for (double ahead_m = from_m; ahead_m < to_m; ahead_m += 0.01) {
      const FloorCell cell = learner_.floor().grid().cell_at(in_map({ahead_m, 0}));
      if (learner_.floor().clearance().to_occupied_m(cell) <= 0) return false;
    }
    return true;
  }

 private:
  static VehicleDescription scanning_cart() {
    VehicleDescription vehicle = cart();
    vehicle.scanner = kGeometry;
    return vehicle;
  }

  Vec2 in_map(const Vec2& p_laser) const {
    return learner_.T_map_vehicle() * kGeometry.T_vehicle_laser * p_laser;
  }

  double stamp_s_ = 0;
  FloorLearner learner_;
};

const Vec2 kThin = 1.5 * unit(kGeometry.beam_angle(60));

TEST(FloorLearner, WhileItStandsItUpdatesTheFloorOnceInManyCycles) {
  StandingCart cart;
  EXPECT_EQ(cart.look({}), FloorLearner::News::kFloor);
  EXPECT_EQ(cart.look({}), FloorLearner::News::kNothing);
  EXPECT_EQ(cart.at(kThin), Floor::kFree);
}

TEST(FloorLearner, ALaserReturnWhereTheFloorIsFreeIsNotSkipped) {
  StandingCart cart;
  cart.look({});
  EXPECT_EQ(cart.look({kThin}), FloorLearner::News::kFloor);
  EXPECT_EQ(cart.at(kThin), Floor::kOccupied);
  EXPECT_EQ(cart.look({kThin}), FloorLearner::News::kNothing) << "the floor shows it now";
}

TEST(FloorLearner, TakesPostsRightBesideItsStartForJambsNotForATable) {
  StandingCart before_table, in_door;
  before_table.look({{0.7, 0.4}, {0.7, -0.4}});
  EXPECT_FALSE(before_table.is_open(0, 1));
  in_door.look({{0.08, 0.4}, {0.08, -0.4}});
  EXPECT_TRUE(in_door.is_open(0, 1));
}

}  // namespace
}  // namespace aisle
