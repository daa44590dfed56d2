#include "aisle/learning/room_learning.hpp"

#include <gmock/gmock.h>

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

VehicleDescription room_cart() {
  VehicleDescription vehicle;
  vehicle.front_steered.wheelbase_m = 0.75;
  return vehicle;
}

/// Straight on, 1 cm a cycle.
std::vector<RoomCycle> drive(int cycles) {
  std::vector<RoomCycle> trip(static_cast<std::size_t>(cycles));
  for (RoomCycle& cycle : trip) cycle.odometry = FrontSteeredMotion{.distance_m = 0.01};
  trip.front().patch = RouteBrightness{150, 2};
  return trip;
}

TEST(RoomLearning, MarksBecomeTurningsWithTheirDistances) {
  auto trip = drive(500);
  trip[99].marks = {{Mark::Kind::kTurningBegins, "5"}};
  trip[299].marks = {{Mark::Kind::kTurningEnds, "5"}};
  trip[499].marks = {{Mark::Kind::kStop, "dead-end"}};
  const auto learned = learn_room_route(trip, room_cart(), {});
  ASSERT_TRUE(learned.ok()) << to_string(learned.problems());
  const RoomRoute& room = *learned->route.room;
  ASSERT_THAT(room.turnings, SizeIs(1));
  EXPECT_EQ(room.turnings[0].number, 5);
  EXPECT_NEAR(room.turnings[0].start_m, 1, 1e-9);
  EXPECT_NEAR(room.turnings[0].end_m, 3, 1e-9);
  EXPECT_EQ(room.parking, ParkingStrategy::kDeadEnd);
  EXPECT_EQ(room.brightness.grey, 150);
  EXPECT_NEAR(learned->route.path.length_m(), 4.99, 0.02);
  EXPECT_THAT(learned->T_route_vehicle, SizeIs(500));
}

TEST(RoomLearning, MarksThatDoNotGoTogetherAreAllReported) {
  auto trip = drive(100);
  trip[10].marks = {{Mark::Kind::kTurningEnds, "5"}};
  trip[20].marks = {{Mark::Kind::kTurningBegins, "14"}};
  trip[30].marks = {{Mark::Kind::kTurningBegins, "3"}};
  trip[90].marks = {{Mark::Kind::kStop, "garage"}};
  const auto learned = learn_room_route(trip, room_cart(), {});
  ASSERT_FALSE(learned.ok());
  const std::string all = to_string(learned.problems());
  EXPECT_THAT(all, HasSubstr("a turning ends that has not begun"));
  EXPECT_THAT(all, HasSubstr("'14' is no turning"));
  EXPECT_THAT(all, HasSubstr("turning 3 has no end"));
  EXPECT_THAT(all, HasSubstr("'garage' is no way to park"));
}

TEST(RoomLearning, NeedsAWayPicturesAndAFrame) {
  auto still = drive(5);
  still.front().patch.reset();
  const auto none = learn_room_route(still, room_cart(), {});
  ASSERT_FALSE(none.ok());
  EXPECT_THAT(none.problems(), SizeIs(2));
  auto no_frame = drive(200);
  no_frame.back().marks = {{Mark::Kind::kStop, "frame"}};
  EXPECT_FALSE(learn_room_route(no_frame, room_cart(), {}).ok());
}

TEST(RoomLearning, EdgesThatSeveralPicturesShowAreKeptWhereTheyWereSeenLast) {
  auto trip = drive(100);
  for (std::size_t i = 0; i < trip.size(); ++i) {
    const double x = 0.01 * static_cast<double>(i);  // odometry's first reading counts
    if (i < 50) trip[i].p_vehicle_edges = {Vec2(2.01 - x, 0.51)};
  }
  trip[60].p_vehicle_edges = {Vec2(1, -0.5)};
  const auto learned = learn_room_route(trip, room_cart(), {});
  ASSERT_TRUE(learned.ok()) << to_string(learned.problems());
  const std::vector<RouteEdge>& edges = learned->route.room->edges;
  ASSERT_THAT(edges, SizeIs(1));
  EXPECT_NEAR(edges[0].along_m, 0.49, 0.001);
  EXPECT_NEAR(edges[0].p_map.x(), 2.02, 0.02);
  EXPECT_NEAR(edges[0].p_map.y(), 0.51, 1e-6);
}

}  // namespace
}  // namespace aisle
