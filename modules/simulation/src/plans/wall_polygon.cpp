#include "plans/wall_polygon.hpp"

#include <cmath>
#include <optional>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kMeetingAngleMin_rad = 8 * kDegree;
constexpr double kMeetingDistanceMax = 3;  ///< cells from where the plan has the corner
constexpr double kSamePoint = 0.05;        ///< cells
constexpr double kOnLine = 0.02;           ///< cells

std::optional<Vec2> meeting_point(const StraightPiece& a, const StraightPiece& b) {
  const double sine = cross(a.along, b.along);
  if (std::abs(sine) < std::sin(kMeetingAngleMin_rad)) return std::nullopt;
  const Vec2 meeting = a.on_line + cross(b.on_line - a.on_line, b.along) / sine * a.along;
  if ((meeting - a.last).norm() > kMeetingDistanceMax) return std::nullopt;
  return meeting;
}

/// Where one piece ends and where the next begins.
struct Joint {
  Vec2 end;
  Vec2 start;
};

Joint joint_of(const StraightPiece& a, const StraightPiece& b) {
  if (const auto meeting = meeting_point(a, b)) return {*meeting, *meeting};
  return {a.projected(a.last), b.projected(a.last)};
}

/// Takes out pieces that run backwards between their joints, of neighbours only the first; true if there were
/// any.
bool drop_reversed(std::vector<StraightPiece>& pieces) {
  std::vector<StraightPiece> kept;
  bool dropped_before = false;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const StraightPiece& before = pieces[(i + pieces.size() - 1) % pieces.size()];
    const StraightPiece& after = pieces[(i + 1) % pieces.size()];
    const Vec2 step = joint_of(pieces[i], after).end - joint_of(before, pieces[i]).start;
    dropped_before = !dropped_before && step.dot(pieces[i].along) <= kSamePoint;
    if (!dropped_before) kept.push_back(pieces[i]);
  }
  const bool dropped = kept.size() < pieces.size();
  pieces = std::move(kept);
  return dropped;
}

std::vector<Vec2> corners_of(const std::vector<StraightPiece>& pieces) {
  std::vector<Vec2> corners;
  const auto add = [&](const Vec2& p) {
    if (corners.empty() || (p - corners.back()).norm() > kSamePoint) corners.push_back(p);
  };
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Joint joint = joint_of(pieces[i], pieces[(i + 1) % pieces.size()]);
    add(joint.end);
    add(joint.start);
  }
  while (corners.size() > 1 && (corners.front() - corners.back()).norm() <= kSamePoint) corners.pop_back();
  return corners;
}

bool is_between(const Vec2& a, const Vec2& p, const Vec2& b) {
  const Vec2 step = b - a;
  const double length = step.norm();
  return length > 0 && std::abs(cross(step, p - a)) / length <= kOnLine && (p - a).dot(b - p) >= 0;
}

/// The corners without those at which the outline goes straight on.
std::vector<Vec2> turning_corners(const std::vector<Vec2>& corners) {
  std::vector<Vec2> turning;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2& before = turning.empty() ? corners.back() : turning.back();
    if (!is_between(before, corners[i], corners[(i + 1) % corners.size()])) turning.push_back(corners[i]);
  }
  return turning;
}

}  // namespace

std::vector<Segment2> closed_polygon(std::vector<StraightPiece> pieces) {
  while (pieces.size() > 2 && drop_reversed(pieces)) {
  }
  const std::vector<Vec2> corners = turning_corners(corners_of(pieces));
  std::vector<Segment2> sides;
  if (corners.size() < 3) return sides;
  for (std::size_t i = 0; i < corners.size(); ++i)
    sides.push_back({corners[i], corners[(i + 1) % corners.size()]});
  return sides;
}

}  // namespace aisle
