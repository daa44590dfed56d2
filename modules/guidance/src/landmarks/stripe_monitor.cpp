#include "aisle/guidance/landmarks/stripe_monitor.hpp"

#include <algorithm>

#include "aisle/core/square.hpp"

namespace aisle {
namespace {

constexpr SceneJump<Vec2>::Limits kWalls{.compared_min = 60, .other_share_max = 0.3, .same_share_min = 0.7};
constexpr std::size_t kLookedUpEach = 4;  // one point in four is compared
constexpr double kLitSpot_m = 0.1;        // tolerance for the same place, plus ...
constexpr double kLitSpotShare = 0.05;    // ... this share of the distance

/// Share of one image's laser returns that another image shows in the same place.
double lit_share(std::span<const Vec2> image, std::span<const Vec2> other) {
  std::size_t compared = 0, same = 0;
  for (std::size_t i = 0; i < image.size(); i += kLookedUpEach) {
    const double reach_m2 = square(kLitSpot_m + kLitSpotShare * image[i].norm());
    const auto is_near = [&](const Vec2& p) { return (p - image[i]).squaredNorm() < reach_m2; };
    ++compared;
    same += std::any_of(other.begin(), other.end(), is_near) ? 1 : 0;
  }
  return static_cast<double>(same) / static_cast<double>(compared);
}

void carry_lit(std::vector<Vec2>& p_vehicle_returns, const Pose2& T_now_before) {
  for (Vec2& p : p_vehicle_returns) p = T_now_before * p;
}

}  // namespace

void StripeMonitor::move(const Pose2& T_before_now) {
  jump_.move(T_before_now, carry_lit);
}

bool StripeMonitor::look(std::span<const Vec2> p_vehicle_returns, bool is_known_here) {
  return jump_.look(p_vehicle_returns, is_known_here, kWalls, lit_share);
}

}  // namespace aisle
