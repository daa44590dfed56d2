#include "aisle/guidance/exploration/floor_learner.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "../cart.hpp"

namespace aisle {
namespace {

constexpr std::size_t kBeams = 181;
constexpr std::size_t kThinAt = 60;  // the beam that may strike something thin ...
constexpr float kThin_m = 1.5;       // ... so far away

/// The cart stands in a room of 8 m by 8 m, its laser in the middle.
class StandingCart {
 public:
  StandingCart() : learner_({}, scanning_cart(), scanner_slices(scanning_cart())) {}

  FloorLearner::News look(bool strikes_thin) {
    Observation observation{.stamp_s = stamp_s_ += 0.1};
    std::vector<float> ranges_m(kBeams);
    for (std::size_t beam = 0; beam < kBeams; ++beam) {
      const Vec2 along = unit(kFan.beam_angle(beam)).cwiseAbs();
      ranges_m[beam] = static_cast<float>(4 / std::max(along.x(), along.y()));
    }
    if (strikes_thin) ranges_m[kThinAt] = kThin_m;
    observation.scan = RangeScan{.ranges_m = std::move(ranges_m)};
    return learner_.take(observation);
  }

  Floor at_thin() const {
    return learner_.floor().at(Vec2(learner_.T_map_vehicle() * kFan.T_vehicle_laser *
                                    Vec2(kThin_m * unit(kFan.beam_angle(kThinAt)))));
  }

 private:
  static VehicleDescription scanning_cart() {
    VehicleDescription vehicle = cart();
    vehicle.scanner = kFan;
    return vehicle;
  }

  double stamp_s_ = 0;
  FloorLearner learner_;
};

TEST(FloorLearner, WhileItStandsOneLookInManyCyclesIsEnough) {
  StandingCart cart;
  EXPECT_EQ(cart.look(false), FloorLearner::News::kFloor);
  EXPECT_EQ(cart.look(false), FloorLearner::News::kNothing);
  EXPECT_EQ(cart.at_thin(), Floor::kFree);
}

TEST(FloorLearner, WhatIsStruckWhereTheFloorShowsNothingIsNotPassedOver) {
  StandingCart cart;
  cart.look(false);
  EXPECT_EQ(cart.look(true), FloorLearner::News::kFloor);
  EXPECT_EQ(cart.at_thin(), Floor::kOccupied);
  EXPECT_EQ(cart.look(true), FloorLearner::News::kNothing) << "the floor shows it now";
}

}  // namespace
}  // namespace aisle
