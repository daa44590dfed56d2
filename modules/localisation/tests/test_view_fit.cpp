#include "aisle/localisation/view_fit.hpp"

#include <gtest/gtest.h>

#include "hand_building.hpp"

namespace aisle {
namespace {

constexpr double kBeamPiece_m = 0.15, kViewReach_m = 16;

std::vector<ViewBeam> seen_from(const Building& building, const Pose2& T_map_vehicle, std::uint64_t seed) {
  Random random(seed);
  std::vector<ViewBeam> beams;
  for (const Vec2& hit : hand::scan(building, T_map_vehicle, kViewReach_m, random))
    beams.push_back({Vec2::Zero(), hit});
  return beams;
}

/// In an exact map a beam that passes the corner of an alcove by a hair is not one that goes through it.
TEST(ViewFit, AtTheTruePoseInAnExactMapEverythingIsExplained) {
  const Building building = hand::corridor_with_alcoves();
  const SurfaceField field(building);
  int beams = 0, explained = 0;
  double misfit_m = 0, surface_m = 0;
  for (int i = 0; i < 60; ++i) {
    const Pose2 T_map_vehicle{1 + 28 * i / 59.0, 0.5 + 0.02 * i, 0.1 * i};
    const auto seen = seen_from(building, T_map_vehicle, static_cast<std::uint64_t>(i));
    const ViewFit fit = fit_of(field, seen, kBeamPiece_m, T_map_vehicle, {});
    beams += fit.beams;
    explained += fit.explained;
    misfit_m += fit.misfit_m;
    surface_m += kBeamPiece_m * fit.beams;
  }
  EXPECT_GE(explained, 0.998 * beams);
  EXPECT_LE(misfit_m, 0.005 * surface_m);
}

TEST(ViewFit, BeamsThroughAWallCountTwice) {
  const Building building = hand::l_room();
  const SurfaceField field(building);
  const std::vector<ViewBeam> beams(
      4, {Vec2::Zero(), {0, 3}});  // from 2 m below the wall at y = 5 to 1 m behind it
  const ViewFit fit = fit_of(field, beams, kBeamPiece_m, {9, 3, 0}, {});
  EXPECT_EQ(fit.through, 4);
  EXPECT_DOUBLE_EQ(fit.misfit_m, 8 * kBeamPiece_m);
  EXPECT_DOUBLE_EQ(fit.chance_m, 16 * kBeamPiece_m);
}

/// A box of half a metre may have been carried away; one of 1 m stays, as walls do.
TEST(ViewFit, WhatCanBeCarriedAwayRefutesNothing) {
  for (const double side_m : {0.5, 1.0}) {
    Building building = hand::l_room();
    hand::add_box({8.5, 1}, side_m, building);
    const SurfaceField field(building);
    const std::vector<ViewBeam> beams(4, {Vec2::Zero(), {0, 4.5}});  // over the box, to the wall at y = 5
    const ViewFit fit = fit_of(field, beams, kBeamPiece_m, {8.75, 0.5, 0}, {});
    EXPECT_EQ(fit.through, side_m < 1 ? 0 : 4) << side_m;
  }
}

/// Parameters that leave no room between "on" and "near" make a step of the ramp, and no number that is none.
TEST(ViewFit, WithoutARampAHitIsOnASurfaceOrNot) {
  const SurfaceField field(hand::l_room());
  const std::vector<ViewBeam> beams(4, {Vec2::Zero(), {0, 2}});
  EXPECT_DOUBLE_EQ(fit_of(field, beams, kBeamPiece_m, {9, 2.95, 0}, {.on_m = 0.05, .near_m = 0.05}).misfit_m,
                   0);
  EXPECT_DOUBLE_EQ(fit_of(field, beams, kBeamPiece_m, {9, 2.95, 0}, {.on_m = 0.3, .near_m = 0.1}).misfit_m,
                   0);
}

/// Whoever is 10 cm off explains all, but worse than whoever is not.
TEST(ViewFit, AHitIsTheLessExplainedTheFartherItIsFromItsSurface) {
  const Building building = hand::l_room();
  const SurfaceField field(building);
  const std::vector<ViewBeam> beams(4, {Vec2::Zero(), {0, 2}});
  const auto misfit_m = [&](double off_m) {
    const ViewFit fit = fit_of(field, beams, kBeamPiece_m, {9, 3 - off_m, 0}, {});
    EXPECT_EQ(fit.explained, 4);
    return fit.misfit_m;
  };
  EXPECT_DOUBLE_EQ(misfit_m(0), 0);
  EXPECT_DOUBLE_EQ(misfit_m(0.04), 0);
  EXPECT_NEAR(misfit_m(0.1), 2 * kBeamPiece_m, 1e-9);
}

}  // namespace
}  // namespace aisle
