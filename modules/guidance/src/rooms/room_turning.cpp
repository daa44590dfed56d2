/// How RoomNavigator reverses between two turnings that are too close together (L96 section 3.3).

#include <algorithm>
#include <vector>

#include "aisle/control/reversing.hpp"
#include "aisle/guidance/rooms/room_navigator.hpp"

namespace aisle {
namespace {

/// The first turning that ends beyond `along_m`; nullptr if there is none.
const RoomTurning* turning_beyond(const std::vector<RoomTurning>& turnings, double along_m) {
  const auto next = std::find_if(turnings.begin(), turnings.end(),
                                 [&](const RoomTurning& turning) { return turning.end_m > along_m; });
  return next == turnings.end() ? nullptr : &*next;
}

bool is_backwards(const PathPiece& piece) {
  return piece.arc.length_m < 0;
}

}  // namespace

bool RoomNavigator::is_on_path_back() const {
  return is_backwards(route_.path.pieces()[progress_.point().piece]);
}

/// An obstacle just before the end of a leg need not be passed if the next leg leads back.
bool RoomNavigator::has_path_back_next() const {
  constexpr double kNearEnough_m = 0.5;
  const std::size_t piece = progress_.point().piece, next = route_.path.leg_end(piece);
  return next < route_.path.pieces().size() && is_backwards(route_.path.pieces()[next]) &&
         route_.path.leg_end_m(piece) - progress_.point().along_m < kNearEnough_m;
}

void RoomNavigator::begin_path_back() {
  if (!is_on_path_back())
    progress_ = PathProgress(route_.path, route_.path.leg_end_m(progress_.point().piece));
  back_to_m_ = route_.path.leg_end_m(progress_.point().piece);
  const RoomTurning* next = turning_beyond(route_.room->turnings, back_to_m_);
  backs_to_corner_ = params_.corner_backing.by_corner && next != nullptr;
  if (backs_to_corner_)
    corner_backing_->begin(class_of_turning(next->number), back_to_m_ - progress_.point().along_m,
                           T_odom_vehicle());
  learn_floor_behind();
  state_ = State::kBackingBetweenTurnings;
}

std::optional<bool> RoomNavigator::has_seen_corner() const {
  if (!backs_to_corner_) return std::nullopt;
  return corner_backing_->has_seen_corner();
}

Decision RoomNavigator::back_between_turnings() {
  const double requested_rad = backs_to_corner_
                                   ? corner_backing_->requested_steering_rad()
                                   : reversing_steering_rad(vehicle_, route_.path, progress_.point(), pose(),
                                                            kLateBendAhead_m, steering_rad_);
  const SteeringChoice choice = choose_steering_behind(requested_rad);
  const bool is_far_enough =
      backs_to_corner_ ? corner_backing_->is_done(T_odom_vehicle()) : !is_on_path_back();
  if (is_far_enough || choice.free_m < params_.stop_free_m) {
    const bool is_by_corner = backs_to_corner_ && corner_backing_->has_seen_corner();
    progress_ = PathProgress(route_.path, std::max(progress_.point().along_m, back_to_m_));
    state_ = State::kFollowing;
    return {.state = "backing",
            .why = is_by_corner ? "sees the corner of the route" : "as far as it was taught"};
  }
  return {.command = {.speed_mps = -params_.corner_backing.speed_mps, .steering_rad = choice.steering_rad},
          .state = "backing",
          .why = backs_to_corner_ ? "until the corner of the route is seen" : "as it was taught"};
}

}  // namespace aisle
