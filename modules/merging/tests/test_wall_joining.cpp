#include "wall_joining.hpp"

#include <gmock/gmock.h>

namespace aisle {
namespace {

Wall wall_from_to(const Vec2& start, const Vec2& end, int evidence = kSureEvidence) {
  return {.segment = {start, end}, .is_orthogonal = true, .sigma_m = 0.01, .evidence = evidence};
}

TEST(WallJoining, PiecesOfOneEvidenceThatTouchAreOneAgain) {
  const auto joined = joined_walls(
      {wall_from_to({0, 0}, {2, 0}), wall_from_to({3, 0}, {7, 0}), wall_from_to({2, 0}, {3, 0})});
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_NEAR(joined[0].segment.start.x(), 0, 1e-9);
  EXPECT_NEAR(joined[0].segment.end.x(), 7, 1e-9);
}

TEST(WallJoining, PiecesOfOtherEvidenceStayApart) {
  EXPECT_EQ(joined_walls({wall_from_to({0, 0}, {2, 0}), wall_from_to({2, 0}, {3, 0}, 1)}).size(), 2u);
}

TEST(WallJoining, TheTwoFacesOfAThinWallStayApart) {
  EXPECT_EQ(joined_walls({wall_from_to({0, 0}, {2, 0}), wall_from_to({2, 0.04}, {0, 0.04})}).size(), 2u);
}

TEST(WallJoining, AnOpeningStaysOpen) {
  EXPECT_EQ(joined_walls({wall_from_to({0, 0}, {2, 0}), wall_from_to({2.5, 0}, {4, 0})}).size(), 2u);
}

TEST(WallJoining, AnUncertainCopyOfAWallIsLeftOut) {
  const auto joined = joined_walls({wall_from_to({1, 0.03}, {2, 0.03}, 1), wall_from_to({0, 0}, {5, 0})});
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_EQ(joined[0].evidence, kSureEvidence);
}

}  // namespace
}  // namespace aisle
