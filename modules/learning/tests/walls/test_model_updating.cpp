#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "aisle/core/random.hpp"
#include "aisle/learning/walls/model_updating.hpp"

namespace aisle {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::Field;
using testing::SizeIs;
using testing::UnorderedElementsAre;

constexpr double kSame_m = 1e-9;

using Segments = std::vector<OrthogonalSegment>;

OrthogonalSegment along_x(double y_m, double from_m, double to_m) {
  return {true, y_m, {from_m, to_m}};
}

OrthogonalSegment along_y(double x_m, double from_m, double to_m) {
  return {false, x_m, {from_m, to_m}};
}

Segments updated(const Segments& model, const Segments& view) {
  return update_model(model, view, ModelUpdateParams{});
}

bool lie_alike(const OrthogonalSegment& a, const OrthogonalSegment& b) {
  return a.along_x == b.along_x && std::abs(a.coordinate_m - b.coordinate_m) < kSame_m &&
         std::abs(a.extent.min - b.extent.min) < kSame_m && std::abs(a.extent.max - b.extent.max) < kSame_m;
}

bool are_alike(const OrthogonalSegment& a, const OrthogonalSegment& b) {
  return lie_alike(a, b) && a.min_occurrences == b.min_occurrences && a.max_occurrences == b.max_occurrences;
}

MATCHER_P(LiesLike, expected, "lies like a segment at " + testing::PrintToString(expected.coordinate_m)) {
  return lie_alike(arg, expected);
}

OrthogonalSegment any_segment(Random& random) {
  const double from_m = random.uniform(-3, 3);
  OrthogonalSegment s{
      random.uniform() < 0.5, random.uniform(-1, 1), {from_m, from_m + random.uniform(0.1, 3)}};
  s.min_occurrences = static_cast<int>(random.index(4));
  s.max_occurrences = static_cast<int>(random.index(4));
  return s;
}

Segments any_segments(Random& random) {
  Segments segments(random.index(12));
  for (OrthogonalSegment& s : segments) s = any_segment(random);
  return segments;
}

Segments shuffled(Segments segments, Random& random) {
  for (std::size_t i = segments.size(); i > 1; --i) std::swap(segments[i - 1], segments[random.index(i)]);
  return segments;
}

RC_GTEST_PROP(ModelUpdating, DoesNotDependOnTheOrderOfTheViewOrTheModel, (std::uint64_t seed)) {
  Random random(seed);
  const Segments model = any_segments(random), view = any_segments(random);
  const Segments once = updated(model, view);
  const Segments again = updated(shuffled(model, random), shuffled(view, random));
  RC_ASSERT(std::is_permutation(once.begin(), once.end(), again.begin(), again.end(), are_alike));
}

/// Pieces of walls that stand clearly apart, as one view may show them.
Segments any_view_of_separate_walls(Random& random) {
  Segments view;
  for (int wall = -3; wall <= 3; ++wall) {
    const bool runs_along_x = random.uniform() < 0.5;
    for (std::uint64_t pieces = random.index(4); pieces > 0; --pieces) {
      const double from_m = random.uniform(-5, 5);
      view.push_back(
          {runs_along_x, wall + random.uniform(-0.05, 0.05), {from_m, from_m + random.uniform(0.6, 4)}});
    }
  }
  return view;
}

RC_GTEST_PROP(ModelUpdating, TheSameViewAgainChangesNothingButCounts, (std::uint64_t seed)) {
  Random random(seed);
  const Segments view = any_view_of_separate_walls(random);
  const Segments once = updated({}, view);
  const Segments twice = updated(once, view);
  RC_ASSERT(std::is_permutation(once.begin(), once.end(), twice.begin(), twice.end(), lie_alike));
}

TEST(ModelUpdating, WhatIsSeenTwiceIsAveraged) {
  EXPECT_THAT(updated({along_x(1, 0, 4)}, {along_x(1.1, 0.1, 4.2)}),
              ElementsAre(LiesLike(along_x(1.05, 0.05, 4.1))));
}

TEST(ModelUpdating, WhatOverlapsInPartIsUnited) {
  EXPECT_THAT(updated({along_y(1, 0, 4)}, {along_y(1.1, 3, 6)}), ElementsAre(LiesLike(along_y(1.05, 0, 6))));
}

TEST(ModelUpdating, WhatLiesApartIsAdded) {
  const OrthogonalSegment old = along_x(1, 0, 4);
  for (const OrthogonalSegment& other : {along_x(1.2, 0, 4), along_x(1, 4.5, 6), along_y(1, 0, 4)}) {
    EXPECT_THAT(updated({old}, {other}), UnorderedElementsAre(LiesLike(old), LiesLike(other)));
  }
}

TEST(ModelUpdating, ShortPiecesWhoseEndsNearlyMeetAreOne) {
  EXPECT_THAT(updated({along_x(1, 0, 0.1)}, {along_x(1, 0.2, 0.3)}),
              ElementsAre(LiesLike(along_x(1, 0.1, 0.2))));
}

TEST(ModelUpdating, OneNewSegmentMayUniteSeveralOldOnes) {
  EXPECT_THAT(updated({along_x(1, 0, 2), along_x(1, 3, 5), along_x(2, 0, 5)}, {along_x(1.03, 1, 4)}),
              UnorderedElementsAre(LiesLike(along_x(1.01, 0, 5)), LiesLike(along_x(2, 0, 5))));
}

TEST(ModelUpdating, EndPointsThatAreSeenAgainAreCounted) {
  Segments model;
  for (int sightings = 1; sightings <= 3; ++sightings) {
    model = updated(model, {along_x(1, 0, 4)});
    EXPECT_THAT(model, ElementsAre(AllOf(Field(&OrthogonalSegment::min_occurrences, sightings),
                                         Field(&OrthogonalSegment::max_occurrences, sightings))));
  }
  model = updated(model, {along_x(1, 0, 6)});
  EXPECT_THAT(model, ElementsAre(AllOf(Field(&OrthogonalSegment::min_occurrences, 4),
                                       Field(&OrthogonalSegment::max_occurrences, 1))));
}

TEST(ModelUpdating, AnEmptyViewChangesNothing) {
  const OrthogonalSegment old = along_x(1, 0, 4);
  EXPECT_THAT(updated({old}, {}), ElementsAre(LiesLike(old)));
  EXPECT_THAT(updated({}, {}), SizeIs(0));
}

TEST(ModelUpdating, ASegmentIsDrawnAlongItsAxis) {
  EXPECT_EQ(along_x(1, 2, 3).segment().start, Vec2(2, 1));
  EXPECT_EQ(along_x(1, 2, 3).segment().end, Vec2(3, 1));
  EXPECT_EQ(along_y(1, 2, 3).segment().start, Vec2(1, 2));
  EXPECT_EQ(along_y(1, 2, 3).segment().end, Vec2(1, 3));
}

}  // namespace
}  // namespace aisle
