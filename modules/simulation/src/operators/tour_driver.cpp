#include "aisle/simulation/operators/tour_driver.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace aisle {
namespace {

constexpr double kArrived_m = 0.05;
constexpr double kHeadingGain_1_s = 2;
constexpr double kApproachGain_1_s = 1.5;

}  // namespace

TourDriver::TourDriver(std::vector<Vec2> tour, const TourDriverParams& params)
    : params_(params), tour_(std::move(tour)) {
  tour_.erase(std::unique(tour_.begin(), tour_.end()), tour_.end());
  if (tour_.size() < 2) throw std::invalid_argument("a tour needs two different waypoints");
  carrot_ = tour_[0];
  T_world_vehicle_ = {tour_[0].x(), tour_[0].y(), heading_of(tour_[1] - tour_[0])};
}

bool TourDriver::has_arrived() const {
  return next_ == tour_.size() && (carrot_ - T_world_vehicle_.position()).norm() < kArrived_m;
}

void TourDriver::advance_carrot() {
  constexpr double kStep_m = 0.01;
  while (next_ < tour_.size() && (carrot_ - T_world_vehicle_.position()).norm() < params_.look_ahead_m) {
    const Vec2 to_next = tour_[next_] - carrot_;
    if (to_next.norm() > kStep_m) {
      carrot_ += kStep_m * to_next.normalized();
    } else {
      carrot_ = tour_[next_++];
    }
  }
}

Arc TourDriver::step(double time_s) {
  advance_carrot();
  const Vec2 to_carrot = carrot_ - T_world_vehicle_.position();
  const double off_rad = wrap_angle(heading_of(to_carrot) - T_world_vehicle_.theta);
  const double turn_rate_rad_s =
      std::clamp(kHeadingGain_1_s * off_rad, -params_.turn_rate_max_rad_s, params_.turn_rate_max_rad_s);
  const double facing = std::max(0.0, std::cos(off_rad));
  const double wanted_mps =
      std::min(params_.speed_max_mps, kApproachGain_1_s * to_carrot.norm()) * facing * facing;
  const double change_max_mps = params_.acceleration_max_mps2 * time_s;
  speed_mps_ += std::clamp(wanted_mps - speed_mps_, -change_max_mps, change_max_mps);

  const Arc arc{speed_mps_ * time_s, turn_rate_rad_s * time_s};
  T_world_vehicle_ = T_world_vehicle_ * end_pose(arc);
  return arc;
}

}  // namespace aisle
