#include "aisle/guidance/stripe_watch.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/core/square.hpp"

namespace aisle {
namespace {

constexpr std::size_t kLitMin = 60;       // points, to be compared
constexpr std::size_t kLookedUpEach = 4;  // so many points one is looked up
constexpr double kLitSpot_m = 0.1;        // in the same place ...
constexpr double kLitSpotShare = 0.05;    // ... and so much of the distance more
constexpr double kJumpedShareMax = 0.3;
constexpr double kStandingShareMin = 0.7;
constexpr double kCarriedWay_m = 0.5;
constexpr double kCarriedTurn_rad = 10 * kDegree;

/// How much of what one picture shows lit another one shows in the same place.
double lit_share(std::span<const Vec2> picture, std::span<const Vec2> other) {
  std::size_t compared = 0, same = 0;
  for (std::size_t i = 0; i < picture.size(); i += kLookedUpEach) {
    const double reach_m2 = square(kLitSpot_m + kLitSpotShare * picture[i].norm());
    const auto is_near = [&](const Vec2& p) { return (p - picture[i]).squaredNorm() < reach_m2; };
    ++compared;
    same += std::any_of(other.begin(), other.end(), is_near) ? 1 : 0;
  }
  return static_cast<double>(same) / static_cast<double>(compared);
}

}  // namespace

void StripeWatch::move(const Pose2& T_before_now) {
  const Pose2 T_now_before = T_before_now.inverse();
  for (Vec2& p : known_) p = T_now_before * p;
  for (Vec2& p : other_) p = T_now_before * p;
  since_known_m_ += T_before_now.position().norm();
  since_known_rad_ += T_before_now.theta;
}

bool StripeWatch::look(std::span<const Vec2> p_vehicle_lit, bool is_known_here) {
  if (p_vehicle_lit.size() < kLitMin) return false;
  const bool can_tell = known_.size() >= kLitMin && since_known_m_ < kCarriedWay_m &&
                        std::abs(since_known_rad_) < kCarriedTurn_rad;
  const bool goes_on = is_known_here || !can_tell || lit_share(p_vehicle_lit, known_) > kJumpedShareMax;
  const bool is_elsewhere =
      !goes_on && other_.size() >= kLitMin && lit_share(p_vehicle_lit, other_) >= kStandingShareMin;
  if (!goes_on && !is_elsewhere) {
    other_.assign(p_vehicle_lit.begin(), p_vehicle_lit.end());
    return false;
  }
  known_.assign(p_vehicle_lit.begin(), p_vehicle_lit.end());
  since_known_m_ = since_known_rad_ = 0;
  other_.clear();
  return is_elsewhere;
}

}  // namespace aisle
