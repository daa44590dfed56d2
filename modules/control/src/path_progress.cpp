#include "aisle/control/path_progress.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kAhead_m = 1, kBack_m = 0.5;
constexpr double kArrived_m = 0.01;
constexpr double kTurned_rad = 1 * kDegree;
constexpr double kFacing_rad = 45 * kDegree;

/// For each pass of the path by the vehicle, the distance along the path to its nearest point.
std::vector<double> passes_by(const Path& path, const Pose2& T_map_vehicle, double off_max_m) {
  constexpr double kStep_m = 0.05;
  std::vector<double> passes_m;
  double nearest_m = 0;  // of the present pass
  bool was_by = false;
  const int steps = static_cast<int>(path.length_m() / kStep_m);
  for (int i = 0; i <= steps; ++i) {
    const double along_m = i * kStep_m;
    const Pose2 off = between(path.at(along_m).T_map_path, T_map_vehicle);
    const double off_m = off.position().norm();
    const bool is_by = off_m <= off_max_m && std::abs(off.theta) <= kFacing_rad;
    if (is_by && !was_by) passes_m.push_back(along_m);
    if (is_by && (!was_by || off_m < nearest_m)) {
      passes_m.back() = along_m;
      nearest_m = off_m;
    }
    was_by = is_by;
  }
  return passes_m;
}

}  // namespace

PathProgress::PathProgress(const Path& path, double along_m)
    : PathProgress(path, along_m <= 0 ? path.nearest(path.pieces().front().T_map_start.position(), 0, 0, 0, 1)
                                      : path.at(along_m)) {}

PathProgress::PathProgress(const Path& path, const PathPoint& from) : path_(&path), point_(from) {
  while (path.leg_end(leg_begin_) <= point_.piece) leg_begin_ = path.leg_end(leg_begin_);
}

const PathPoint& PathProgress::advance(const Pose2& T_map_vehicle) {
  move_on_leg(T_map_vehicle.position());
  while (!has_arrived_ && is_leg_done(T_map_vehicle)) {
    const std::size_t next = path_->leg_end(leg_begin_);
    has_arrived_ = next == path_->pieces().size();
    if (has_arrived_) break;
    leg_begin_ = next;
    point_ = {.piece = next, .along_m = path_->start_m(next)};
    move_on_leg(T_map_vehicle.position());
  }
  return point_;
}

bool PathProgress::find(const Pose2& T_map_vehicle, double off_max_m) {
  const std::vector<double> passes_m = passes_by(*path_, T_map_vehicle, off_max_m);
  if (passes_m.empty()) return false;
  const auto distance_to = [this](double along_m) { return std::abs(along_m - point_.along_m); };
  *this = PathProgress(*path_, *std::min_element(passes_m.begin(), passes_m.end(), [&](double a, double b) {
    return distance_to(a) < distance_to(b);
  }));
  return true;
}

void PathProgress::move_on_leg(const Vec2& p_map) {
  point_ = path_->nearest(p_map, point_.along_m - kBack_m, point_.along_m + kAhead_m, leg_begin_,
                          path_->leg_end(leg_begin_));
}

bool PathProgress::is_leg_done(const Pose2& T_map_vehicle) const {
  const std::size_t last = path_->leg_end(leg_begin_) - 1;
  const PathPiece& piece = path_->pieces()[last];
  if (piece.is_on_the_spot()) {
    return std::abs(wrap_angle(piece.end().theta - T_map_vehicle.theta)) < kTurned_rad;
  }
  return path_->start_m(last) + piece.path_m() - point_.along_m < kArrived_m;
}

}  // namespace aisle
