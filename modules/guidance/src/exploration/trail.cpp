#include "aisle/guidance/exploration/trail.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kMarkEvery_m = 0.2;
constexpr double kMarkEvery_rad = 10 * kDegree;
constexpr double kMoved_m = 0.005;  // in a cycle: less says nothing about the gear
constexpr double kThere_m = 0.05;   // within this distance a mark is reached
constexpr double kAt_m = 0.1;       // within these limits the vehicle is on the trail
constexpr double kAt_rad = 6 * kDegree;
constexpr double kPullIn_m = 0.4;  // of path over which the cross-track error is corrected
constexpr double kAlmostStraight_rad = 1e-6;

/// An arc that the wheels can drive to about another pose: to its heading, and a little nearer to the trail.
Arc arc_to(const Pose2& T_from_to) {
  const double chord_m = T_from_to.position().norm();
  if (chord_m < kThere_m) return {0, T_from_to.theta};
  const double half_rad = T_from_to.theta / 2;
  const double bent = std::abs(half_rad) < kAlmostStraight_rad ? 1 : half_rad / std::sin(half_rad);
  const double length_m = std::copysign(chord_m * bent, T_from_to.x);
  const double off_m = T_from_to.y - end_pose({length_m, T_from_to.theta}).y;
  return {length_m, T_from_to.theta + length_m * off_m / (kPullIn_m * kPullIn_m)};
}

bool is_at(const Pose2& T_map_vehicle, const Pose2& T_map_mark) {
  const Pose2 off = between(T_map_mark, T_map_vehicle);
  return off.position().norm() < kAt_m && std::abs(off.theta) < kAt_rad;
}

/// Adds the arc to another pose, unless the path is there already. @return where the path ends
Pose2 go_on_to(const Pose2& T_map_mark, const Pose2& T_map_end, std::vector<PathPiece>& pieces) {
  const Arc arc = arc_to(between(T_map_end, T_map_mark));
  const bool is_there = arc.length_m == 0 && std::abs(arc.turn_rad) < kMarkEvery_rad;
  if (is_there) return T_map_end;
  pieces.push_back({T_map_end, arc});
  return pieces.back().end();
}

}  // namespace

void Trail::go_on(const Pose2& T_map_vehicle, std::size_t scan) {
  const double moved_m = between(latest_.T_map_vehicle, T_map_vehicle).x;
  const std::optional<Gear> gear = std::abs(moved_m) < kMoved_m ? gear_ : gear_of(moved_m);
  const bool turns_about = !marks_.empty() && gear != gear_;
  if (turns_about) marks_.push_back(latest_);
  gear_ = gear;
  latest_ = {T_map_vehicle, scan};
  const Pose2 since = marks_.empty() ? Pose2{} : between(marks_.back().T_map_vehicle, T_map_vehicle);
  if (marks_.empty() || since.position().norm() >= kMarkEvery_m || std::abs(since.theta) >= kMarkEvery_rad)
    marks_.push_back(latest_);
}

void Trail::go_back(const Pose2& T_map_vehicle) {
  latest_.T_map_vehicle = T_map_vehicle;
  const auto off_m = [&](const Mark& mark) {
    return (mark.T_map_vehicle.position() - T_map_vehicle.position()).norm();
  };
  while (marks_.size() > 1 && off_m(marks_[marks_.size() - 2]) <= off_m(marks_.back())) marks_.pop_back();
}

void Trail::lay_again(std::span<const Pose2> T_map_vehicle) {
  for (Mark& mark : marks_) mark.T_map_vehicle = T_map_vehicle[mark.scan];
}

Path Trail::path_back(const Pose2& T_map_vehicle, double path_m,
                      const std::function<bool(const Pose2&)>& is_roomy) const {
  std::vector<PathPiece> pieces;
  Pose2 T_map_end = T_map_vehicle;
  double left_m = path_m;
  for (auto mark = marks_.rbegin(); mark != marks_.rend() && (left_m > 0 || !is_roomy(T_map_end)); ++mark) {
    const std::size_t before = pieces.size();
    T_map_end = go_on_to(mark->T_map_vehicle, T_map_end, pieces);
    if (pieces.size() > before) left_m -= std::abs(pieces.back().arc.length_m);
  }
  return Path(std::move(pieces));
}

Path Trail::path_to_begin(const Pose2& T_map_begin, const Pose2& T_map_vehicle, double away_m,
                          const std::function<bool(const Pose2&)>& is_roomy) const {
  const auto T_map_of = [&](const Mark& mark) {
    return T_map_begin * between(marks_.front().T_map_vehicle, mark.T_map_vehicle);
  };
  const auto from = std::find_if(marks_.begin(), marks_.end(), [&](const Mark& mark) {
    const Pose2 T_map_mark = T_map_of(mark);
    const bool is_near = (T_map_mark.position() - T_map_begin.position()).norm() < away_m;
    return is_near ? is_at(T_map_vehicle, T_map_mark) : is_roomy(T_map_mark);
  });
  if (from == marks_.end()) return {};
  std::vector<PathPiece> pieces;
  Pose2 T_map_end = T_map_of(*from);
  for (auto mark = std::make_reverse_iterator(from); mark != marks_.rend(); ++mark)
    T_map_end = go_on_to(T_map_of(*mark), T_map_end, pieces);
  return Path(std::move(pieces));
}

}  // namespace aisle
