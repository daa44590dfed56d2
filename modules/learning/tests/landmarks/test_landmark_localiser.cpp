#include <gmock/gmock.h>

#include <algorithm>
#include <span>
#include <vector>

#include "aisle/maps/cell_index.hpp"
#include "corridor_run.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

constexpr SightNoise kNoise;

UncertainPose2 somewhere_about(const Pose2& T, double along_m, double across_m, double sigma_rad) {
  return {T, Vec3(square(along_m), square(across_m), square(sigma_rad)).asDiagonal()};
}

/// Doors 0.9 m apart on both walls, on and on: every line has a look-alike on either side.
std::vector<CorridorLine> lookalike_doors(double from_m, double to_m) {
  std::vector<CorridorLine> lines;
  for (double x = from_m; x < to_m; x += 0.9) {
    lines.push_back({{x, 1.1}, false});
    lines.push_back({{x + 0.3, -1.1}, true});
  }
  return lines;
}

TEST(LandmarkLocaliser, CorrectsAStartThatIsOff) {
  constexpr int kTrials = 40;
  Random random(3);
  double off_m2 = 0, turned_rad2 = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const std::vector<CorridorLine> lines = corridor_lines(12, random);
    const Pose2 truth{3 + random.normal(0.1), random.normal(0.1), random.normal(2 * kDegree)};
    LandmarkLocaliser localiser({}, corridor_cart(), somewhere_about({3, 0, 0}, 0.15, 0.15, 3 * kDegree));
    const std::vector<LandmarkSighting> seen = sightings_from(lines, truth, kNoise, &random);
    ASSERT_EQ(localiser.correct(map_of(lines), seen), LandmarkMatch::kMatched) << trial;
    EXPECT_GT(localiser.matched_share(), 0.8);
    const Pose2 off = between(truth, localiser.pose());
    off_m2 += off.position().squaredNorm() / kTrials;
    turned_rad2 += square(off.theta) / kTrials;
  }
  EXPECT_LT(std::sqrt(off_m2), 0.03);  // it began 14 cm and 2 degrees off
  EXPECT_LT(std::sqrt(turned_rad2), 0.5 * kDegree);
}

/// A small turn shifts a few lines at one distance as a sideways step does.
TEST(LandmarkLocaliser, KnownWallsAtTheStartGiveTheHeadingThatTheFirstLandmarksHardlyGive) {
  const std::vector<CorridorLine> lines{{{8, -0.5}, false}, {{8.1, 0.1}, true}, {{8, 0.6}, false}};
  const LandmarkMap map = map_of(lines);
  const Pose2 truth{3, 0, 0};
  SensedSegment along;
  along.length_m = 3;
  along.sigma_heading_rad = 0.3 * kDegree;
  const std::vector<SensedSegment> edges{along};
  const std::vector<LandmarkSighting> seen = sightings_from(lines, truth, kNoise);
  const auto heading_off_rad = [&](const std::optional<WallDirection>& walls) {
    LandmarkLocaliser localiser({}, corridor_cart(), {});
    localiser.place(somewhere_about({3, 0.15, 2 * kDegree}, 0.15, 0.15, 3 * kDegree), walls);
    EXPECT_EQ(localiser.correct(map, seen, edges), LandmarkMatch::kMatched);
    return std::abs(localiser.pose().theta);
  };
  EXPECT_GT(heading_off_rad({}), 0.6 * kDegree);
  EXPECT_LT(heading_off_rad(WallDirection{.sigma_rad = 0.2 * kDegree}), 0.3 * kDegree);
}

TEST(LandmarkLocaliser, PairsEverySightingWithTheLandmarkThatItShows) {
  Random random(4);
  const std::vector<CorridorLine> lines = corridor_lines(12, random);
  const Pose2 truth{3.1, -0.1, 0.03};
  const std::vector<LandmarkSighting> seen = sightings_from(lines, truth, kNoise);
  LandmarkLocaliser localiser({}, corridor_cart(), somewhere_about({3, 0, 0}, 0.15, 0.15, 3 * kDegree));
  localiser.correct(map_of(lines), seen);
  ASSERT_EQ(localiser.pairs().size(), seen.size());
  for (const LandmarkPair& pair : localiser.pairs()) {
    EXPECT_THAT(truth * seen[pair.sighting].p_vehicle, PointNear(lines[pair.landmark].p_map, 1e-9));
  }
}

/// A vague landmark is within few standard deviations of anything around.
TEST(LandmarkLocaliser, ALandmarkThatIsHardlyKnownTakesNoSightingFromOneThatIsKnownBetter) {
  Random random(4);
  const std::vector<CorridorLine> lines = corridor_lines(12, random);
  LandmarkMap map = map_of(lines);
  std::vector<LandmarkSighting> seen = sightings_from(lines, {3, 0, 0}, kNoise);
  LandmarkSighting& off =
      *std::min_element(seen.begin(), seen.end(), [](const LandmarkSighting& a, const LandmarkSighting& b) {
        return a.p_vehicle.norm() < b.p_vehicle.norm();
      });
  const auto shown = static_cast<std::size_t>(
      std::find_if(lines.begin(), lines.end(),
                   [&](const CorridorLine& line) {
                     return (Pose2{3, 0, 0} * off.p_vehicle - line.p_map).norm() < 1e-9;
                   }) -
      lines.begin());
  Landmark vague = map[shown];
  vague.p_map += Vec2(0.06, 0);
  vague.covariance = square(0.1) * Mat2::Identity();
  map.add(vague);
  off.p_vehicle += Vec2(0.02, 0);
  LandmarkLocaliser localiser({}, corridor_cart(), somewhere_about({3, 0, 0}, 0.05, 0.05, kDegree));
  ASSERT_EQ(localiser.correct(map, seen), LandmarkMatch::kMatched);
  const auto taken = std::find_if(localiser.pairs().begin(), localiser.pairs().end(),
                                  [&](const LandmarkPair& pair) { return &seen[pair.sighting] == &off; });
  ASSERT_NE(taken, localiser.pairs().end());
  EXPECT_EQ(taken->landmark, shown);
}

TEST(LandmarkLocaliser, AmongLookAlikeDoorsOdometryCarriesThePoseWithoutJumps) {
  const LandmarkMap map = map_of(lookalike_doors(-9, 40));
  const VehicleDescription cart = corridor_cart();
  Pose2 truth{3.45, 0, 0};  // half way between two look-alikes of the believed pose
  LandmarkLocaliser localiser({}, cart, somewhere_about({3, 0, 0}, 0.5, 0.02, 0.5 * kDegree));
  Pose2 carried = localiser.pose();
  for (int i = 0; i < 20; ++i) {
    const FrontSteeredMotion step{0.05, 0};
    truth = truth * drive(cart.front_steered, step);
    carried = carried * drive(cart.front_steered, step);
    localiser.predict(step);
    const std::vector<LandmarkSighting> seen = sightings_from(lookalike_doors(-9, 40), truth, kNoise);
    ASSERT_EQ(localiser.correct(map, seen), LandmarkMatch::kAmbiguous) << i;
    EXPECT_THAT(localiser.pairs(), testing::IsEmpty());
    EXPECT_THAT(localiser.pose(), PoseNear(carried, 1e-9, 1e-9));
  }
}

TEST(LandmarkLocaliser, OneUniqueLandmarkTellsLookAlikeDoorsApart) {
  std::vector<CorridorLine> lines = lookalike_doors(-9, 40);
  for (const double x : {4.7, 5.05, 5.75, 6.0}) lines.push_back({{x, -1.1}, false});
  const Pose2 truth{3.4, 0, 0};
  LandmarkLocaliser localiser({}, corridor_cart(), somewhere_about({3, 0, 0}, 0.4, 0.02, 0.5 * kDegree));
  EXPECT_EQ(localiser.correct(map_of(lines), sightings_from(lines, truth, kNoise)), LandmarkMatch::kMatched);
  EXPECT_THAT(localiser.pose(), PoseNear(truth, 0.02, 0.3 * kDegree));
}

TEST(LandmarkLocaliser, DoorsBeyondThePoseUncertaintyAreNoRivals) {
  const Pose2 truth{3.1, 0.02, 0};
  LandmarkLocaliser localiser({}, corridor_cart(), somewhere_about({3, 0, 0}, 0.1, 0.02, 0.5 * kDegree));
  const std::vector<LandmarkSighting> seen = sightings_from(lookalike_doors(-9, 40), truth, kNoise);
  EXPECT_EQ(localiser.correct(map_of(lookalike_doors(-9, 40)), seen), LandmarkMatch::kMatched);
  EXPECT_THAT(localiser.pose(), PoseNear(truth, 0.02, 0.3 * kDegree));
}

TEST(LandmarkLocaliser, LandmarksSeenFromThisSideCountMoreThanThoseSeenFromTheOther) {
  Random random(5);
  const std::vector<CorridorLine> lines = corridor_lines(12, random);
  LandmarkMap map;
  for (const CorridorLine& line : lines) {
    Landmark landmark{.p_map = line.p_map, .seen_from = {-1, 0}, .brighter_right = line.brighter_right};
    map.add(landmark);
    landmark.p_map += Vec2(0.25, -0.15);  // drift of the run by the time it came back
    landmark.weight = 2;
    landmark.seen_from = {1, 0};
    map.add(landmark);
  }
  const Pose2 truth{3.05, 0.03, 0};
  LandmarkLocaliser localiser({}, corridor_cart(), somewhere_about({3, 0, 0}, 0.15, 0.15, 3 * kDegree));
  ASSERT_EQ(localiser.correct(map, sightings_from(lines, truth, kNoise)), LandmarkMatch::kMatched);
  EXPECT_THAT(localiser.pose(), PoseNear(truth, 0.03, 0.5 * kDegree));
}

TEST(LandmarkLocaliser, TwoLinesCloseTogetherAreToldApartByTheirBrighterSides) {
  Random random(6);
  std::vector<CorridorLine> frames = corridor_lines(12, random);
  const std::size_t count = frames.size();
  for (std::size_t i = 0; i < count; ++i)  // the other edge of every frame
    frames.push_back({frames[i].p_map + Vec2(0.07, 0), !frames[i].brighter_right});
  const LandmarkMap map = map_of(frames);
  const Pose2 truth{3.02, 0, 0};
  const std::vector<CorridorLine> seen_edges(frames.begin(),
                                             frames.begin() + static_cast<std::ptrdiff_t>(count));
  const std::vector<LandmarkSighting> seen = sightings_from(seen_edges, truth, kNoise);
  LandmarkLocaliser localiser({}, corridor_cart(), somewhere_about({3, 0, 0}, 0.03, 0.03, 0.5 * kDegree));
  ASSERT_EQ(localiser.correct(map, seen), LandmarkMatch::kMatched);
  EXPECT_FALSE(localiser.pairs().empty());
  for (const LandmarkPair& pair : localiser.pairs())
    EXPECT_EQ(map[pair.landmark].brighter_right, seen[pair.sighting].brighter_right);
}

TEST(LandmarkLocaliser, OtherLandmarksThanTheMapHasHereAreNotMatched) {
  Random random(8);
  const std::vector<CorridorLine> here = corridor_lines(12, random);
  std::vector<CorridorLine> elsewhere = here;
  for (CorridorLine& line : elsewhere) line.brighter_right = !line.brighter_right;
  LandmarkLocaliser localiser({}, corridor_cart(), somewhere_about({3, 0, 0}, 0.05, 0.05, 1 * kDegree));
  const LandmarkMatch match = localiser.correct(map_of(here), sightings_from(elsewhere, {3, 0, 0}, kNoise));
  EXPECT_EQ(match, LandmarkMatch::kUnmatched);
  EXPECT_THAT(localiser.pose(), PoseNear(Pose2{3, 0, 0}, 0, 0));
}

TEST(LandmarkLocaliser, ThreePairsFarFromThePredictionAreCoincidenceAndManyAreNot) {
  Random random(9);
  const std::vector<CorridorLine> lines = corridor_lines(12, random);
  const LandmarkMap map = map_of(lines);
  const Pose2 predicted{3, 0, 0}, elsewhere{3.06, 0.06, 0.9 * kDegree};
  std::vector<LandmarkSighting> seen = sightings_from(lines, elsewhere, kNoise);
  std::sort(seen.begin(), seen.end(), [](const LandmarkSighting& a, const LandmarkSighting& b) {
    return a.p_vehicle.norm() < b.p_vehicle.norm();
  });
  ASSERT_GT(seen.size(), 5U);
  LandmarkLocaliser localiser({}, corridor_cart(), somewhere_about(predicted, 0.005, 0.005, 0.1 * kDegree));
  EXPECT_NE(localiser.correct(map, std::span(seen).first(3)), LandmarkMatch::kMatched);
  EXPECT_THAT(localiser.pose(), PoseNear(predicted, 0, 0));
  EXPECT_EQ(localiser.correct(map, seen), LandmarkMatch::kMatched);
  EXPECT_GT((localiser.pose().position() - predicted.position()).norm(), 0.001)
      << "so the prediction was wrong";
}

TEST(LandmarkLocaliser, UnknownLinesBesideTheKnownOnesContradictNothing) {
  Random random(8);
  const std::vector<CorridorLine> lines = corridor_lines(12, random);
  const SightNoise grainy{.grain = 40};
  for (int i = 0; i < 20; ++i) {
    LandmarkLocaliser localiser({}, corridor_cart(), somewhere_about({3, 0, 0}, 0.02, 0.02, 0.5 * kDegree));
    EXPECT_NE(localiser.correct(map_of(lines), sightings_from(lines, {3, 0, 0}, grainy, &random)),
              LandmarkMatch::kUnmatched);
    EXPECT_LT(localiser.matched_share(), 0.5);
  }
}

TEST(LandmarkLocaliser, UnknownLinesWhereKnownOnesCannotBeSeenContradictNothing) {
  Random random(8);
  const std::vector<CorridorLine> lines = corridor_lines(12, random);
  std::vector<CorridorLine> others = lines;
  for (CorridorLine& line : others) line.brighter_right = !line.brighter_right;
  const Pose2 path_back{9, 0, kPi};  // the map knows the sides that are seen on the way there
  LandmarkLocaliser localiser({}, corridor_cart(), somewhere_about(path_back, 0.05, 0.05, 1 * kDegree));
  EXPECT_EQ(localiser.correct(map_of(lines), sightings_from(others, path_back, kNoise)),
            LandmarkMatch::kNothing);
  EXPECT_THAT(localiser.pose(), PoseNear(path_back, 0, 0));
}

TEST(LandmarkLocaliser, NothingSeenAndNothingKnownSayNothing) {
  Random random(9);
  const std::vector<CorridorLine> lines = corridor_lines(12, random);
  LandmarkLocaliser localiser({}, corridor_cart(), somewhere_about({3, 0, 0}, 0.05, 0.05, 1 * kDegree));
  EXPECT_EQ(localiser.correct(map_of(lines), {}), LandmarkMatch::kNothing);
  EXPECT_EQ(localiser.correct({}, sightings_from(lines, {3, 0, 0}, kNoise)), LandmarkMatch::kNothing);
  EXPECT_THAT(localiser.pose(), PoseNear(Pose2{3, 0, 0}, 0, 0));
}

TEST(LandmarkLocaliser, AHundredThousandLandmarksElsewhereChangeNeitherTheAnswerNorTheCost) {
  Random random(10);
  const std::vector<CorridorLine> lines = corridor_lines(12, random);
  const Pose2 truth{3.1, 0.05, 0.02};
  const std::vector<LandmarkSighting> seen = sightings_from(lines, truth, kNoise, &random);
  LandmarkMap small = map_of(lines), large = map_of(lines);
  CellIndex index;  // as the map has one
  for (int i = 0; i < 100'000; ++i) {
    Landmark far;
    far.p_map = {random.uniform(40, 1000), random.uniform(-500, 500)};
    index.add({far.p_map, far.p_map}, static_cast<int>(large.add(far)));
  }
  const UncertainPose2 thought = somewhere_about({3, 0, 0}, 0.1, 0.1, 2 * kDegree);
  LandmarkLocaliser in_small({}, corridor_cart(), thought), in_large({}, corridor_cart(), thought);
  ASSERT_EQ(in_small.correct(small, seen), LandmarkMatch::kMatched);
  ASSERT_EQ(in_large.correct(large, seen), LandmarkMatch::kMatched);
  EXPECT_THAT(in_large.pose(), PoseNear(in_small.pose(), 0, 0));
  EXPECT_EQ(in_large.pairs().size(), in_small.pairs().size());
  std::vector<int> touched;
  index.query(thought.mean.position(), thought.mean.position(), 10, touched);
  EXPECT_THAT(touched, testing::IsEmpty());
}

double position_sigma_m(const LandmarkLocaliser& localiser) {
  return std::sqrt(localiser.covariance().topLeftCorner<2, 2>().trace());
}

TEST(LandmarkLocaliser, DoesNotBecomeSurerByTheSameImageAgainAndAgain) {
  Random random(9);
  const std::vector<CorridorLine> lines = corridor_lines(12, random);
  const LandmarkMap map = map_of(lines);
  const std::vector<LandmarkSighting> seen = sightings_from(lines, {3.1, 0.05, 0}, kNoise, &random);
  LandmarkLocaliser localiser({}, corridor_cart(), somewhere_about({3, 0, 0}, 0.15, 0.15, 3 * kDegree));
  ASSERT_EQ(localiser.correct(map, seen), LandmarkMatch::kMatched);
  const double at_first_m = position_sigma_m(localiser);
  for (int i = 0; i < 100; ++i) {
    localiser.predict(FrontSteeredMotion{});
    ASSERT_EQ(localiser.correct(map, seen), LandmarkMatch::kMatched);
  }
  EXPECT_GT(position_sigma_m(localiser), 0.7 * at_first_m);
}

TEST(LandmarkLocaliser, BecomesSurerByTheImagesOnItsPath) {
  Random random(9);
  const std::vector<CorridorLine> lines = corridor_lines(12, random);
  const LandmarkMap map = map_of(lines);
  Pose2 truth{3.1, 0.05, 0};
  LandmarkLocaliser localiser({}, corridor_cart(), somewhere_about({3, 0, 0}, 0.15, 0.15, 3 * kDegree));
  ASSERT_EQ(localiser.correct(map, sightings_from(lines, truth, kNoise)), LandmarkMatch::kMatched);
  const double at_first_m = position_sigma_m(localiser);
  constexpr double kStep_m = 0.03;
  for (int i = 0; i < 20; ++i) {
    truth = truth * Pose2{kStep_m, 0, 0};
    localiser.predict(FrontSteeredMotion{.distance_m = kStep_m});
    ASSERT_EQ(localiser.correct(map, sightings_from(lines, truth, kNoise)), LandmarkMatch::kMatched);
  }
  EXPECT_LT(position_sigma_m(localiser), 0.5 * at_first_m);
}

}  // namespace
}  // namespace aisle
