#include "aisle/control/path_progress.hpp"

#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kAhead_m = 1, kBack_m = 0.5;
constexpr double kArrived_m = 0.01;
constexpr double kTurned_rad = 1 * kDegree;

}  // namespace

PathProgress::PathProgress(const Path& path, double along_m) : path_(&path), point_(path.at(along_m)) {
  if (along_m <= 0) point_ = path.nearest(path.pieces().front().T_map_start.position(), 0, 0, 0, 1);
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
  return path_->start_m(last) + piece.way_m() - point_.along_m < kArrived_m;
}

}  // namespace aisle
