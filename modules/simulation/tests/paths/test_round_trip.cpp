#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "aisle/geometry/polyline.hpp"
#include "aisle/simulation/paths/round_trip.hpp"

namespace aisle {
namespace {

World world_of(const std::vector<Segment2>& walls) {
  World world;
  for (const Segment2& wall : walls) world.walls.push_back({.floor_edge = wall});
  return world;
}

/// A tour that never leaves the walls' box by more than the grid's rim of two cells.
bool stays_inside(const std::vector<Vec2>& tour, const Vec2& low, const Vec2& high) {
  const Vec2 rim = Vec2::Constant(0.2);
  return std::all_of(tour.begin(), tour.end(), [&](const Vec2& p) {
    return ((p - low + rim).array() >= 0).all() && ((high + rim - p).array() >= 0).all();
  });
}

TEST(RoundTrip, FloorThatIsOpenToTheRimEndsThere) {
  SilentProgress silent;
  const auto run =
      plan_round_trip(world_of({{{0, 0}, {4.5, 0}}, {{4.5, 0}, {4.5, 3}}, {{-1, -1}, {9, 9}}}), {}, silent);
  ASSERT_TRUE(run.has_value());
  EXPECT_TRUE(stays_inside(run->tour, {-1, -1}, {9, 9}));
  EXPECT_LT(polyline_length_m(run->tour), 200);
}

RC_GTEST_PROP(RoundTrip, NoWallsLeadOutOfTheirBox, ()) {
  const auto coordinate = [] { return *rc::gen::inRange(-80, 80) / 10.0; };
  std::vector<Segment2> walls;
  Vec2 low = Vec2::Constant(1e9), high = -low;
  for (int i = *rc::gen::inRange(1, 6); i > 0; --i) {
    walls.push_back({{coordinate(), coordinate()}, {coordinate(), coordinate()}});
    for (const Vec2& p : {walls.back().start, walls.back().end})
      low = low.cwiseMin(p), high = high.cwiseMax(p);
  }
  SilentProgress silent;
  const auto run = plan_round_trip(world_of(walls), {}, silent);
  RC_PRE(run.has_value());
  RC_ASSERT(stays_inside(run->tour, low, high));
}

/// Reports come often, so that Ctrl-C is heard in the midst of large floors.
class InterruptedSoon final : public Progress {
 public:
  void report(std::string_view task, std::size_t, std::size_t) override {
    if (task == "covering the floor") throw Interrupted{};
  }
};

TEST(RoundTrip, CoveringTheFloorCanBeInterrupted) {
  InterruptedSoon progress;
  const World hall =
      world_of({{{0, 0}, {30, 0}}, {{30, 0}, {30, 30}}, {{30, 30}, {0, 30}}, {{0, 30}, {0, 0}}});
  EXPECT_THROW(plan_round_trip(hall, {}, progress), Interrupted);
}

}  // namespace
}  // namespace aisle
