#include "aisle/evaluation/exploration/wall_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/core/square.hpp"
#include "aisle/maps/cell_index.hpp"

namespace aisle {
namespace {

constexpr double kPointEvery_m = 0.05;
constexpr double kSamePlace_m = 0.15;
constexpr double kSameDirection_rad = 20 * kDegree;
constexpr double kTrueWallMin_m = 0.5;

class WallPoints {
 public:
  explicit WallPoints(std::vector<Segment2> walls) : walls_(std::move(walls)) {
    for (std::size_t i = 0; i < walls_.size(); ++i) index_.add(walls_[i], static_cast<int>(i));
  }

  /// Distance to the nearest wall within reach whose direction deviates by at most an angle; infinity if
  /// none.
  double distance_m(const Vec2& p, double heading_rad, double turned_max_rad) {
    index_.query(p, p, kSamePlace_m, near_);
    double least_m = std::numeric_limits<double>::infinity();
    for (const int i : near_) {
      const Segment2& wall = walls_[static_cast<std::size_t>(i)];
      const double turned_rad = std::abs(std::remainder(wall.heading() - heading_rad, kPi));
      if (turned_rad <= turned_max_rad) least_m = std::min(least_m, wall.distance(p));
    }
    return least_m <= kSamePlace_m ? least_m : std::numeric_limits<double>::infinity();
  }

 private:
  std::vector<Segment2> walls_;
  CellIndex index_;
  std::vector<int> near_;
};

/// Midpoints of equal pieces of about 5 cm.
template <class Use>
void for_each_point(const Segment2& wall, Use use) {
  const int pieces = std::max(1, static_cast<int>(std::lround(wall.length() / kPointEvery_m)));
  for (int i = 0; i < pieces; ++i)
    use(Vec2(wall.start + (i + 0.5) / pieces * (wall.end - wall.start)), wall.length() / pieces);
}

}  // namespace

WallErrors wall_errors(const WallMap& learned, const Pose2& T_world_map, std::span<const Segment2> standing,
                       const std::function<bool(const Vec2&)>& is_seen) {
  std::vector<Segment2> learned_walls;
  for (const Wall& wall : learned.walls) learned_walls.push_back(T_world_map * wall.segment);
  WallPoints true_points(std::vector<Segment2>(standing.begin(), standing.end()));
  WallPoints learned_points(learned_walls);
  WallErrors errors;
  for (const Segment2& wall : standing) {
    if (wall.length() < kTrueWallMin_m) continue;
    for_each_point(wall, [&](const Vec2& p, double piece_m) {
      if (!is_seen(p)) return;
      errors.true_m += piece_m;
      if (std::isinf(learned_points.distance_m(p, wall.heading(), kSameDirection_rad)))
        errors.missed_m += piece_m;
    });
  }
  double square_sum = 0;
  for (const Segment2& wall : learned_walls) {
    for_each_point(wall, [&](const Vec2& p, double piece_m) {
      errors.learned_m += piece_m;
      const double distance_m = true_points.distance_m(p, wall.heading(), kPi);
      if (std::isinf(distance_m)) {
        errors.false_m += piece_m;
      } else {
        square_sum += piece_m * square(distance_m);
      }
    });
  }
  const double matched_m = errors.learned_m - errors.false_m;
  if (matched_m > 0) errors.rmse_m = std::sqrt(square_sum / matched_m);
  return errors;
}

}  // namespace aisle
