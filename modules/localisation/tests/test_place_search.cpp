#include "aisle/localisation/place_search.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "hand_building.hpp"

namespace aisle {
namespace {

constexpr double kPiece_m = 0.1;

SurfaceView view_from(const Building& building, const Pose2& T_map_vehicle) {
  Random random(5);
  std::vector<ViewBeam> beams;
  for (const Vec2& hit : hand::scan(building, T_map_vehicle, 20, random))
    beams.push_back({Vec2::Zero(), hit});
  return view_of(std::move(beams), kPiece_m);
}

TEST(PlaceSearch, FindsTheSameInSlicesAndNoSliceIsLonger) {
  const Building building = hand::bare_room();
  const SurfaceField field(building);
  const LikelihoodPyramid map(field);
  const SurfaceView view = view_from(building, {3, 2, 0.4});
  PlaceSearchParams at_once, in_slices;
  at_once.nodes_per_scan = std::numeric_limits<int>::max();
  in_slices.nodes_per_scan = 1000;
  PlaceSearch whole(field, map, view, PlaceCandidates(at_once), at_once);
  EXPECT_TRUE(whole.advance());
  PlaceSearch sliced(field, map, view, PlaceCandidates(in_slices), in_slices);
  for (bool has_ended = false; !has_ended;) {
    const std::size_t before = sliced.nodes();
    has_ended = sliced.advance();
    EXPECT_LE(sliced.nodes() - before, 1000U + 32U) << "and one division of a node";
  }
  EXPECT_TRUE(whole.is_complete());
  EXPECT_TRUE(sliced.is_complete());
  EXPECT_EQ(sliced.nodes(), whole.nodes());
  ASSERT_EQ(whole.places().all().size(), 2U);
  ASSERT_EQ(sliced.places().all().size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const Pose2& T_sliced = sliced.places().all()[i].T_map_vehicle;
    const Pose2& T_whole = whole.places().all()[i].T_map_vehicle;
    EXPECT_EQ(T_sliced.position(), T_whole.position());
    EXPECT_EQ(T_sliced.theta, T_whole.theta);
  }
}

TEST(PlaceSearch, PlacesThatAreKnownShortenItAndStay) {
  const Building building = hand::l_room();
  const SurfaceField field(building);
  const LikelihoodPyramid map(field);
  const Pose2 T_map_vehicle{2, 4, 0.4};
  const SurfaceView view = view_from(building, T_map_vehicle);
  PlaceSearchParams params;
  params.nodes_per_scan = std::numeric_limits<int>::max();
  PlaceSearch fresh(field, map, view, PlaceCandidates(params), params);
  ASSERT_TRUE(fresh.advance());
  ASSERT_EQ(fresh.places().rivals().size(), 1U);
  PlaceSearch again(field, map, view, fresh.places(), params);
  ASSERT_TRUE(again.advance());
  EXPECT_TRUE(again.is_complete());
  ASSERT_EQ(again.places().rivals().size(), 1U);
  EXPECT_LT((again.places().rivals()[0].T_map_vehicle.position() - T_map_vehicle.position()).norm(), 0.02);
  EXPECT_LE(again.nodes(), fresh.nodes());
}

}  // namespace
}  // namespace aisle
