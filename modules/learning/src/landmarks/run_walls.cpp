#include "landmarks/run_walls.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/core/square.hpp"

namespace aisle {
namespace {

constexpr double kOneDirection_m = 2;  // length of path over which walls give one direction
constexpr double kLeastDirectionSigma_rad = 0.15 * kDegree;
constexpr double kNoDirectionSigma_rad = kPi / 4;  // modulo a quarter turn: less sure says nothing
class DirectionMean {
 public:
  void add(double direction_rad, double sigma_rad) {
    if (information_ == 0) first_rad_ = direction_rad;
    const double information = 1 / square(sigma_rad);
    information_ += information;
    off_rad_ += information * wrap_quarter_turn(direction_rad - first_rad_);
  }

  WallDirection seen_from(const Vec2& p_map) const {
    return {.p_map = p_map,
            .direction_rad = wrap_quarter_turn(first_rad_ + off_rad_ / information_),
            .sigma_rad = std::max(std::sqrt(1 / information_), kLeastDirectionSigma_rad)};
  }

 private:
  double first_rad_ = 0, off_rad_ = 0, information_ = 0;
};

}  // namespace

std::vector<WallDirection> wall_directions(std::span<const WallObservation> seen,
                                           std::span<const Pose2> T_map_vehicle) {
  std::vector<WallDirection> directions;
  for (std::size_t i = 0; i < seen.size();) {
    const WallObservation& first = seen[i];
    const Vec2 p_map = T_map_vehicle[first.cycle].position();
    DirectionMean mean;
    for (; i < seen.size() && seen[i].walls == first.walls; ++i) {
      const Pose2& T_map_seen_from = T_map_vehicle[seen[i].cycle];
      if ((T_map_seen_from.position() - p_map).norm() > kOneDirection_m) break;
      mean.add(T_map_seen_from.theta - seen[i].against_walls.heading_rad, seen[i].against_walls.sigma_rad);
    }
    const WallDirection walls = mean.seen_from(p_map);
    if (walls.sigma_rad < kNoDirectionSigma_rad) directions.push_back(walls);
  }
  return directions;
}

}  // namespace aisle
