#include "aisle/learning/rooms/room_learning.hpp"

#include <gmock/gmock.h>

#include "aisle/maps/view_pattern.hpp"
#include "rooms/pattern_views.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

VehicleDescription room_cart() {
  VehicleDescription vehicle;
  vehicle.front_steered.wheelbase_m = 0.75;
  return vehicle;
}

/// Straight on, 1 cm per cycle.
std::vector<RoomCycle> drive(int cycles) {
  std::vector<RoomCycle> run(static_cast<std::size_t>(cycles));
  for (RoomCycle& cycle : run) cycle.odometry = FrontSteeredMotion{.distance_m = 0.01};
  run.front().patch = RouteBrightness{150, 2};
  return run;
}

TEST(RoomLearning, MarksBecomeTurningsWithTheirDistances) {
  auto run = drive(500);
  run[99].marks = {{Mark::Kind::kTurningBegins, "5"}};
  run[299].marks = {{Mark::Kind::kTurningEnds, "5"}};
  run[499].marks = {{Mark::Kind::kStop, "dead-end"}};
  const auto learned = learn_room_route(run, room_cart(), {});
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
  auto run = drive(100);
  run[10].marks = {{Mark::Kind::kTurningEnds, "5"}};
  run[20].marks = {{Mark::Kind::kTurningBegins, "14"}};
  run[30].marks = {{Mark::Kind::kTurningBegins, "3"}};
  run[90].marks = {{Mark::Kind::kStop, "garage"}};
  const auto learned = learn_room_route(run, room_cart(), {});
  ASSERT_FALSE(learned.ok());
  const std::string all = to_string(learned.problems());
  EXPECT_THAT(all, HasSubstr("a turning ends that has not begun"));
  EXPECT_THAT(all, HasSubstr("'14' is no turning"));
  EXPECT_THAT(all, HasSubstr("turning 3 has no end"));
  EXPECT_THAT(all, HasSubstr("'garage' is no way to park"));
}

TEST(RoomLearning, NeedsAPathImagesAndAFrame) {
  auto still = drive(5);
  still.front().patch.reset();
  const auto none = learn_room_route(still, room_cart(), {});
  ASSERT_FALSE(none.ok());
  EXPECT_THAT(none.problems(), SizeIs(2));
  auto no_frame = drive(200);
  no_frame.back().marks = {{Mark::Kind::kStop, "frame"}};
  EXPECT_FALSE(learn_room_route(no_frame, room_cart(), {}).ok());
}

/// Points on the sides of a frame of 1.64 m x 1.14 m straight ahead; of its first part only, or all.
std::vector<Vec2> painted_ahead(double middle_m, double shown_m) {
  std::vector<Vec2> points;
  for (double x = 0; x < shown_m; x += 0.02) {
    for (const double y : {0.57, -0.57}) points.emplace_back(middle_m - 0.82 + x, y);
  }
  for (double y = -0.57; y < 0.57; y += 0.02) {
    points.emplace_back(middle_m - 0.82, y);
    if (shown_m >= 1.64) points.emplace_back(middle_m + 0.82, y);
  }
  return points;
}

TEST(RoomLearning, AFramePartlyInViewAtFirstIsMeasuredWhenFullyInView) {
  auto run = drive(400);
  run.back().marks = {{Mark::Kind::kStop, "frame"}};
  for (std::size_t i = 100; i < 250; ++i) {
    const double middle_m = 4.5 - 0.01 * static_cast<double>(i);
    run[i].p_vehicle_painted = painted_ahead(middle_m, i < 200 ? 0.4 : 1.64);
  }
  const auto learned = learn_room_route(run, room_cart(), {});
  ASSERT_TRUE(learned.ok()) << to_string(learned.problems());
  EXPECT_NEAR(learned->route.room->frame_size_m.x(), 1.64, 0.03);
  EXPECT_NEAR(learned->route.room->frame_size_m.y(), 1.14, 0.03);
}

TEST(RoomLearning, EdgesThatSeveralImagesShowAreKeptWhereTheyWereSeenLast) {
  auto run = drive(100);
  for (std::size_t i = 0; i < run.size(); ++i) {
    const double x = 0.01 * static_cast<double>(i);  // odometry's first reading counts
    if (i < 50) run[i].p_vehicle_edges = {Vec2(2.01 - x, 0.51)};
  }
  run[60].p_vehicle_edges = {Vec2(1, -0.5)};
  const auto learned = learn_room_route(run, room_cart(), {});
  ASSERT_TRUE(learned.ok()) << to_string(learned.problems());
  const std::vector<RouteEdge>& edges = learned->route.room->edges;
  ASSERT_THAT(edges, SizeIs(1));
  EXPECT_NEAR(edges[0].along_m, 0.49, 0.001);
  EXPECT_NEAR(edges[0].p_map.x(), 2.02, 0.02);
  EXPECT_NEAR(edges[0].p_map.y(), 0.51, 1e-6);
}

/// Straight to a taught place, 1 m back and 1.3 m on, with a view of its own in each cycle.
std::vector<RoomCycle> drive_about_place() {
  auto run = drive(430);
  run[199].marks = {{Mark::Kind::kStop, "view"}};
  for (std::size_t i = 0; i < run.size(); ++i) {
    if (i >= 200 && i < 300) run[i].odometry = FrontSteeredMotion{.distance_m = -0.01};
    run[i].view = PlaceView{.brightness = {0.001 * static_cast<double>(i)}, .columns = {}};
  }
  return run;
}

TEST(RoomLearning, ThePathEndsAtTheStopMark) {
  const auto learned = learn_room_route(drive_about_place(), room_cart(), {});
  ASSERT_TRUE(learned.ok()) << to_string(learned.problems());
  EXPECT_NEAR(learned->route.path.length_m(), 1.99, 0.02);
  EXPECT_THAT(learned->T_route_vehicle, SizeIs(430));
}

TEST(RoomLearning, AFewViewsOfThePatternDoNotReplaceThePathsViews) {
  const auto learned = learn_room_route(drive_about_place(), room_cart(), {});
  ASSERT_TRUE(learned.ok());
  const std::vector<StopView>& views = learned->route.room->views;
  EXPECT_THAT(views, SizeIs(testing::Ge(100U))) << "of the last metre of the path";
  EXPECT_NEAR(views.back().left_m, 0, 1e-9);
}

TEST(PatternViews, AreThoseFromThePlacesOfThePattern) {
  std::vector<RoomCycle> cycles;
  std::vector<Pose2> T_route_vehicle;
  const Pose2 T_route_place{3, 2, 1};
  for (const ViewLane& lane : view_pattern()) {
    for (const double along_m : lane.along_m) {
      for (const double off_m : {-0.04, 0.01}) {
        cycles.emplace_back().view = PlaceView{.brightness = {off_m > 0 ? 1.0 : 0.0}, .columns = {}};
        T_route_vehicle.push_back(T_route_place * lane.at(along_m + off_m));
      }
    }
  }
  const auto views = pattern_views(cycles, T_route_vehicle, T_route_place);
  ASSERT_THAT(views, SizeIs(63));
  EXPECT_NEAR(views.front().left_m, 0.59, 1e-9) << "the first one wanted is 0.6 m before the place";
  for (const StopView& view : views) EXPECT_EQ(view.seen.brightness.front(), 1) << "the nearest image";
}

}  // namespace
}  // namespace aisle
