#include "aisle/localisation/localiser.hpp"

#include <gtest/gtest.h>

#include "hand_building.hpp"

namespace aisle {
namespace {

using hand::scan;

/// A vehicle with a scanner and exact odometry in one building, localising in another or the same.
class Drive {
 public:
  Drive(const Building& world, const Building& known, const Pose2& T_map_vehicle, double reach_m = 20)
      : world_(world), localiser_({}, known), T_map_vehicle_(T_map_vehicle), reach_m_(reach_m) {
    see({});
  }

  /// In steps of 10 cm, or 5 degrees on the spot.
  void go(double distance_m) {
    for (int i = 0; i < static_cast<int>(std::lround(std::abs(distance_m) / 0.1)); ++i)
      see({distance_m > 0 ? 0.1 : -0.1, 0, 0});
  }
  void turn(double angle_rad) {
    for (int i = 0; i < static_cast<int>(std::lround(std::abs(angle_rad) / (5 * kDegree))); ++i)
      see({0, 0, angle_rad > 0 ? 5 * kDegree : -5 * kDegree});
  }
  void stand(int scans) {
    for (int i = 0; i < scans; ++i) see({});
  }
  /// Stands until a search of the whole building has ended.
  void let_it_search() { stand(kScansOfSearch); }
  /// Somebody carries the vehicle away.
  void be_carried_to(const Pose2& T_map_vehicle) { T_map_vehicle_ = T_map_vehicle; }

  Localiser& localiser() { return localiser_; }
  LocaliserState state() const { return localiser_.state(); }
  double off_m() const {
    return (localiser_.T_map_vehicle().mean.position() - T_map_vehicle_.position()).norm();
  }
  double off_rad() const {
    return std::abs(wrap_angle(localiser_.T_map_vehicle().mean.theta - T_map_vehicle_.theta));
  }

 private:
  static constexpr int kScansOfSearch = 100;

  void see(const Pose2& step) {
    T_map_vehicle_ = T_map_vehicle_ * step;
    time_s_ += 0.2;
    localiser_.take_scan({scan(world_, T_map_vehicle_, reach_m_, random_), Vec2::Zero(), time_s_},
                         about(step, 0.01, 0.3 * kDegree));
  }

  const Building& world_;
  Localiser localiser_;
  Pose2 T_map_vehicle_;
  double reach_m_;
  double time_s_ = 0;
  Random random_{7};
};

TEST(Localiser, FindsItselfAnywhereInARoomWithoutLookAlikes) {
  const Building building = hand::l_room();
  Random random(11);
  for (int i = 0; i < 12; ++i) {
    const Pose2 start{random.uniform(0.5, 4.5), random.uniform(3.2, 4.5), random.uniform(-kPi, kPi)};
    Drive drive(building, building, start);
    drive.let_it_search();
    EXPECT_FALSE(drive.localiser().is_found()) << "one view alone is not believed";
    drive.turn(30 * kDegree);
    ASSERT_EQ(drive.state(), LocaliserState::kFound) << "start " << i;
    EXPECT_LT(drive.off_m(), 0.01);
    EXPECT_LT(drive.off_rad(), 0.2 * kDegree);
  }
}

TEST(Localiser, IsNeverSureInASymmetricRoom) {
  const Building building = hand::bare_room();
  Drive drive(building, building, {3, 2, 0.4});
  drive.let_it_search();
  drive.turn(2 * kPi);
  drive.go(2);
  EXPECT_EQ(drive.state(), LocaliserState::kAmbiguous);
  ASSERT_EQ(drive.localiser().places().size(), 2U);
  EXPECT_TRUE(drive.localiser().knows_all_places());
}

TEST(Localiser, BelievesAHintWhereSeveralPlacesFit) {
  const Building building = hand::bare_room();
  Drive drive(building, building, {3, 2, 0.4});
  drive.localiser().take_hint({3.3, 1.8, 0.3});
  drive.let_it_search();
  drive.turn(30 * kDegree);
  ASSERT_EQ(drive.state(), LocaliserState::kFound);
  EXPECT_LT(drive.off_m(), 0.01);
}

TEST(Localiser, DoesNotBelieveAHintThatTheWallsRefute) {
  const Building building = hand::l_room();
  Drive drive(building, building, {2, 4, 0.4});
  drive.localiser().take_hint({9, 2, 0.4});
  drive.let_it_search();
  drive.turn(45 * kDegree);
  EXPECT_TRUE(drive.localiser().hint_was_wrong());
  ASSERT_EQ(drive.state(), LocaliserState::kFound) << "finds itself all the same";
  EXPECT_LT(drive.off_m(), 0.01);
}

TEST(Localiser, IsNotSureBetweenLookAlikesUntilSomethingTellsThemApart) {
  const Building building = hand::corridor_with_alcoves();
  Drive drive(building, building, {10, 1, 0}, 3);  // it sees 3 m far
  drive.let_it_search();
  drive.turn(30 * kDegree);
  drive.turn(-30 * kDegree);
  drive.go(2);
  EXPECT_EQ(drive.state(), LocaliserState::kAmbiguous);
  drive.go(12);
  EXPECT_EQ(drive.state(), LocaliserState::kAmbiguous) << "a missing alcove alone may be a closed door";
  drive.go(5);
  ASSERT_EQ(drive.state(), LocaliserState::kFound) << "it sees the corridor's end";
  EXPECT_LT(drive.off_m(), 0.02);
}

TEST(Localiser, SaysThatThisIsAnotherBuilding) {
  const Building world = hand::l_room(), known = hand::corridor_with_alcoves();
  Drive drive(world, known, {7, 2, 0.4});
  drive.let_it_search();
  drive.turn(kPi);
  EXPECT_EQ(drive.state(), LocaliserState::kNotHere);
}

TEST(Localiser, IsNotSureWhereHalfOfWhatItSeesIsNotInTheMap) {
  const Building known = hand::l_room();
  Building world = known;
  for (const double x : {0.6, 1.9, 3.2}) hand::add_box({x, 6.2}, 0.7, world);
  for (const double y : {2.6, 4.2}) hand::add_box({0.4, y}, 0.7, world);
  hand::add_box({3.4, 3.4}, 0.7, world);
  Drive drive(world, known, {2, 5.2, 0.4});
  drive.let_it_search();
  drive.turn(2 * kPi);
  ASSERT_FALSE(drive.localiser().places().empty());
  const double share = drive.localiser().places().front().fit.explained_share();
  EXPECT_GT(share, PlaceSearchParams{}.explained_min);
  EXPECT_LT(share, 0.75) << "clutter enough to hide a place that explains less";
  EXPECT_EQ(drive.state(), LocaliserState::kAmbiguous) << "a place that was not looked at may fit as well";
}

TEST(Localiser, NoticesThatItWasCarriedAwayAndFindsItselfAgain) {
  const Building building = hand::l_room();
  Drive drive(building, building, {2, 4, 0.4});
  drive.let_it_search();
  drive.turn(30 * kDegree);
  ASSERT_EQ(drive.state(), LocaliserState::kFound);
  drive.be_carried_to({10.2, 1.4, 1.9});
  drive.stand(20);
  EXPECT_FALSE(drive.localiser().is_found());
  drive.let_it_search();
  drive.turn(60 * kDegree);
  ASSERT_EQ(drive.state(), LocaliserState::kFound);
  EXPECT_LT(drive.off_m(), 0.01);
}

TEST(Localiser, FollowsTheVehicleToTheCentimetre) {
  const Building building = hand::l_room();
  Drive drive(building, building, {2, 3.5, 0});
  drive.let_it_search();
  drive.turn(30 * kDegree);
  drive.turn(-30 * kDegree);
  for (int i = 0; i < 6; ++i) {
    drive.go(1);
    ASSERT_EQ(drive.state(), LocaliserState::kFound);
    EXPECT_LT(drive.off_m(), 0.015);
    EXPECT_LT(drive.off_rad(), 0.2 * kDegree);
  }
}

}  // namespace
}  // namespace aisle
