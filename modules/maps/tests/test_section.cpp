#include "aisle/maps/section.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

Section straight(double length_m) {
  return {.kind = Section::Kind::kFollow, .length_m = length_m};
}
Section turn(double turn_rad) {
  return {.kind = Section::Kind::kTurn, .turn_rad = turn_rad};
}
Section curve(double ahead_m, double left_m) {
  return {.kind = Section::Kind::kCurve, .p_start_end = {ahead_m, left_m}};
}

void expect_near(const Pose2& T, double x, double y, double theta) {
  EXPECT_NEAR(T.x, x, 1e-9);
  EXPECT_NEAR(T.y, y, 1e-9);
  EXPECT_NEAR(wrap_angle(T.theta - theta), 0, 1e-9);
}

TEST(Sections, StraightLinesAndTurnsFollowEachOther) {
  const Path path = path_of({straight(3), turn(-kPi / 2), straight(2)}, {1, 1, 0});
  ASSERT_EQ(path.pieces().size(), 3U);
  expect_near(path.end(), 4, -1, -kPi / 2);
}

TEST(Sections, BackIsDrivenBackwards) {
  const Path path = path_of({straight(3), {.kind = Section::Kind::kBack, .length_m = 1}}, {});
  expect_near(path.end(), 2, 0, 0);
  EXPECT_LT(path.pieces().back().arc.length_m, 0);
}

TEST(Sections, EveryPieceKnowsItsSection) {
  std::vector<std::size_t> sections;
  const Path path = path_of({straight(1), curve(0.6, 0.6), straight(1)}, {}, &sections);
  ASSERT_EQ(sections.size(), path.pieces().size());
  EXPECT_EQ(sections.front(), 0U);
  EXPECT_EQ(sections.back(), 2U);
  EXPECT_TRUE(std::is_sorted(sections.begin(), sections.end()));
}

TEST(Sections, ACurveEndsAtP2AQuarterTurnLeft) {
  for (const Vec2& end : {Vec2(0.5, 0.5), Vec2(0.3, 0.9), Vec2(1.2, 0.4)}) {
    const Path path = path_of({curve(end.x(), end.y())}, {});
    expect_near(path.end(), end.x(), end.y(), kPi / 2);
  }
}

TEST(Sections, VerticesLieOnTheParabolaInOrderAndTurnByMultiplesOfTheQuantum) {
  const Vec2 end(0.7, 0.5);
  const std::vector<Vec2> vertices = curve_vertices(end);
  ASSERT_GE(vertices.size(), 3U);
  EXPECT_EQ(vertices.back(), end);
  Vec2 last = Vec2::Zero();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec2& p = vertices[i];
    EXPECT_GT(p.y(), last.y());
    EXPECT_NEAR(p.x(), end.x() - end.x() / (end.y() * end.y()) * (p.y() - end.y()) * (p.y() - end.y()),
                1e-12);
    if (i + 1 < vertices.size()) {
      const double quanta = heading_of(p - last) / kTurnQuantum_rad;
      EXPECT_NEAR(quanta, std::round(quanta), 1e-9);
    }
    last = p;
  }
}

}  // namespace
}  // namespace aisle
