#include "wall_foot_search.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/core/square.hpp"

namespace aisle {

namespace {

/// How many whole steps fit into a length; -1 if it is negative.
int steps_within(double length_px, double step_px) {
  return length_px < 0 ? -1 : static_cast<int>(length_px / step_px);
}

// Shares are of the picture's width unless they say height.
constexpr double kFlattest_rad = 8 * kDegree, kSteepest_rad = 78 * kDegree;
constexpr double kMissAngle = 0.09;  // sine of the angle by which a segment may miss the vanishing point
constexpr double kMissPerLength_px = 1.2;  // more for short segments
constexpr double kMissNear = 0.01;         // and more near the vanishing point
constexpr double kRayLengthMin = 0.02;
constexpr double kSeedLengthMin = 0.05;
constexpr double kSeedFootWeightMin = 0.3;
constexpr double kFootSeedLength_px = 12;
constexpr double kTrustedLength = 0.25;  // a seed this long tells its direction itself
constexpr double kFirstTolerance = 0.008, kTolerance = 0.005;
constexpr int kFits = 3;
constexpr double kPastPointMax = 0.05;   // how far a wall's foot passes the vanishing point
constexpr double kNearPoint = 0.06;      // nearer to the vanishing point nothing can be told apart
constexpr double kFootTolerance = 0.02;  // of the height
constexpr double kCrossingMin = 0.05;    // of the height
constexpr double kAside = 0.03;          // nearer to the vanishing point's column feet are of the far end
constexpr double kDoor = 0.03;           // feet nearer to each other are of one door
constexpr double kReflection = 0.6;      // share of its contrast that a line's reflection has at most
constexpr double kBorder_px = 4;         // a line that ends here is cut by the picture's lower border
constexpr int kBoards = 2;               // a board may stand on another
constexpr double kOtherEdge = 0.6;       // support of a board's lower edge, of that of the upper one
constexpr double kFreeFloor = 0.43;      // share of a board's lower edge beneath which other edges may come
constexpr double kLikeScore = 0.7;
constexpr double kBoardMin = 0.004;      // height of a board, as seen ...
constexpr double kBoardDepthMax = 1.25;  // ... and at most: a fifth of the camera's height
constexpr double kDepthAside = 0.3;      // where heights are compared
constexpr double kFloorStep_px = 8;
constexpr double kFloorBeside = 1.25;     // cells to either side where floor is looked for ...
constexpr double kFloorBeneathBoard = 3;  // ... or beneath a board

/// Scatter of weighted points, for a line through them.
struct Scatter {
  double weight = 0;
  Vec2 sum = Vec2::Zero();
  Mat2 products = Mat2::Zero();

  void add(const Vec2& point, double w) {
    weight += w;
    sum += w * point;
    products += w * point * point.transpose();
  }
  Vec2 mean() const { return sum / weight; }
  Vec2 direction() const {
    const Mat2 spread = products / weight - mean() * mean().transpose();
    return unit(0.5 * std::atan2(2 * spread(0, 1), spread(0, 0) - spread(1, 1)));
  }
};

}  // namespace

double WallFoot::slope_deg() const {
  return std::atan2(direction.y(), direction.x()) / kDegree;
}

/// What the edges alone say.
double WallFoot::support() const {
  return covered * (0.5 + 0.5 * share) * std::min(1.0, contrast / 14 + 0.25);
}

/// Vertical lines end at a wall's foot and do not cross it; floor follows beneath it, and none is above.
double WallFoot::score() const {
  const double feet_alone = 0.02 * std::min(feet, 4.0) * std::min(1.0, contrast / 14 + 0.25);
  const double standing =
      (1 + 0.45 * std::min(feet, 2.5)) * (feet + share + 0.5) / (feet + share + crossings + 0.5);
  const double floored = (0.4 + 0.6 * on_floor) * (1 + at_edge);
  return (support() + feet_alone) * standing * (1 - 0.7 * followed) * floored;
}

std::optional<WallFoot> WallFootSearch::find(const SideView& view, const Vec2& vanishing_point_px,
                                             std::span<const EdgeSegment> segments,
                                             std::span<const SideVertical> verticals, const FloorCells& floor,
                                             double score_min) {
  width_px_ = view.width_px();
  height_px_ = view.height_px();
  vanishing_point_px_ = vanishing_point_px;
  verticals_ = verticals;
  floor_ = &floor;
  gather_rays(segments);
  gather_seeds(verticals);
  feet_.clear();
  for (const Seed& seed : seeds_) {
    auto foot = fitted(seed);
    if (!foot || !is_possible(*foot)) continue;
    measure(view, *foot);
    feet_.push_back(*foot);
  }
  const WallFoot* best = lowest_of_like_score(score_min);
  if (best == nullptr) return std::nullopt;
  return *best;
}

void WallFootSearch::gather_rays(std::span<const EdgeSegment> segments) {
  rays_.clear();
  for (const EdgeSegment& segment : segments) {
    const Vec2 from = segment.middle_px() - vanishing_point_px_;
    if (from.x() < 0.02 * width_px_ || from.y() < 0.015 * height_px_) continue;
    const double length_px = segment.length_px();
    if (length_px < kRayLengthMin * width_px_) continue;
    const double angle = std::atan2(from.y(), from.x());
    if (angle < kFlattest_rad || angle > kSteepest_rad) continue;
    const double miss = std::abs(cross(from, segment.direction())) / from.norm();
    if (miss > kMissAngle + kMissPerLength_px / length_px + kMissNear * width_px_ / from.norm()) continue;
    rays_.push_back(segment);
  }
}

/// Long rays, and rays to the lower ends of vertical lines: where doors hide the wall's foot, only these.
void WallFootSearch::gather_seeds(std::span<const SideVertical> verticals) {
  seeds_.clear();
  for (const EdgeSegment& ray : rays_) {
    if (ray.length_px() < kSeedLengthMin * width_px_) continue;
    seeds_.push_back({ray.middle_px(), ray.direction(), ray.length_px()});
  }
  for (const SideVertical& vertical : verticals) {
    const Vec2 from = vertical.bottom_px - vanishing_point_px_;
    if (vertical.weight < kSeedFootWeightMin || from.x() < 0.03 * width_px_ || from.y() < 0.06 * height_px_)
      continue;
    if (vertical.bottom_px.y() > height_px_ - 5) continue;
    seeds_.push_back({vertical.bottom_px, from.normalized(), kFootSeedLength_px});
  }
}

/// The line through the seed, drawn to the rays and feet near it.
std::optional<WallFoot> WallFootSearch::fitted(const Seed& seed) {
  WallFoot foot;
  foot.point_px = seed.point_px;
  const double trust = std::min(1.0, seed.length_px / (kTrustedLength * width_px_));
  const Vec2 from_point = (seed.point_px - vanishing_point_px_).normalized();
  foot.direction = (trust * seed.direction + (1 - trust) * from_point).normalized();
  for (int round = 0; round < kFits; ++round) {
    const double tolerance_px = (round == 0 ? kFirstTolerance : kTolerance) * width_px_;
    const auto off_px = [&](const Vec2& point) {
      return std::abs(cross(foot.direction, point - foot.point_px));
    };
    Scatter scatter;
    intervals_.clear();
    for (const EdgeSegment& ray : rays_) {
      if (off_px(ray.left_px) > tolerance_px || off_px(ray.right_px) > tolerance_px) continue;
      const double weight = ray.length_px();
      for (const Vec2& point : {ray.left_px, ray.middle_px(), ray.right_px}) scatter.add(point, weight);
      intervals_.emplace_back(foot.direction.dot(ray.left_px - foot.point_px),
                              foot.direction.dot(ray.right_px - foot.point_px));
    }
    for (const SideVertical& vertical : verticals_) {
      if (off_px(vertical.bottom_px) > 1.5 * tolerance_px || vertical.bottom_px.y() > height_px_ - 5)
        continue;
      scatter.add(vertical.bottom_px, 3 * 0.008 * width_px_ * vertical.weight);
    }
    if (scatter.weight <= 0) return std::nullopt;
    if (round + 1 == kFits) break;
    foot.point_px = scatter.mean();
    const Vec2 direction = scatter.direction();
    if ((scatter.products / scatter.weight - scatter.mean() * scatter.mean().transpose()).trace() > 1) {
      foot.direction = direction.dot(foot.direction) < 0 ? Vec2(-direction) : direction;
    }
  }
  if (intervals_.empty()) return std::nullopt;
  std::sort(intervals_.begin(), intervals_.end());
  double covered_px = 0, end_px = intervals_.front().first;
  for (const auto& [from_px, to_px] : intervals_) {
    covered_px += std::max(0.0, to_px - std::max(from_px, end_px));
    end_px = std::max(end_px, to_px);
  }
  foot.from_px = intervals_.front().first;
  foot.to_px = end_px;
  foot.covered = covered_px / width_px_;
  return foot;
}

bool WallFootSearch::is_possible(const WallFoot& foot) const {
  const double angle = std::atan2(foot.direction.y(), foot.direction.x());
  if (angle < kFlattest_rad || angle > kSteepest_rad) return false;
  return std::abs(cross(foot.direction, vanishing_point_px_ - foot.point_px)) <= kPastPointMax * width_px_;
}

void WallFootSearch::measure(const SideView& view, WallFoot& foot) const {
  const double border_px = std::min((width_px_ - 1 - foot.point_px.x()) / foot.direction.x(),
                                    (height_px_ - 1 - foot.point_px.y()) / foot.direction.y());
  const double begin_px = foot.direction.dot(vanishing_point_px_ - foot.point_px) + kNearPoint * width_px_;
  foot.share = std::min(1.0, foot.covered * width_px_ / std::max(border_px - begin_px, 0.1 * width_px_));
  measure_contrast(view, foot);
  measure_verticals(view, foot);
  measure_floor_side(view, foot);
  measure_floor(view, foot);
}

void WallFootSearch::measure_contrast(const SideView& view, WallFoot& foot) const {
  constexpr double kBeside_px = 3, kStep_px = 4;
  const Vec2 beneath = kBeside_px * left_normal(foot.direction);
  int count = 0;
  const int steps = steps_within(foot.to_px - foot.from_px, kStep_px);
  for (int i = 0; i <= steps; ++i) {
    const double along = foot.from_px + i * kStep_px;
    const Vec2 on = foot.point_px + along * foot.direction;
    const Vec2 lower = on + beneath, upper = on - beneath;
    const int lu = static_cast<int>(std::lround(lower.x())), lv = static_cast<int>(std::lround(lower.y()));
    const int uu = static_cast<int>(std::lround(upper.x())), uv = static_cast<int>(std::lround(upper.y()));
    if (!view.contains(lu, lv) || !view.contains(uu, uv)) continue;
    const int step = view.at(lu, lv) - view.at(uu, uv);
    foot.contrast += std::abs(step);
    foot.sign += step;
    ++count;
  }
  if (count == 0) return;
  foot.contrast /= count;
  foot.sign /= count;
}

/// Several lines of one door stand for one foot. A line that is much fainter beneath does not cross: it is
/// followed by its reflection.
void WallFootSearch::measure_verticals(const SideView& view, WallFoot& foot) const {
  double door_px = -width_px_, door_weight = 0;
  for (const SideVertical& vertical : verticals_) {
    if (vertical.bottom_px.x() < vanishing_point_px_.x() + kAside * width_px_) continue;
    const double v_px = foot.v_at(vertical.bottom_px.x());
    if (vertical.top_px.y() > foot.v_at(vertical.top_px.x()) || v_px > height_px_ - kBorder_px) continue;
    const double beneath = (vertical.bottom_px.y() - v_px) / height_px_;
    if (std::abs(beneath) < kFootTolerance) {
      if (vertical.bottom_px.x() > door_px + kDoor * width_px_) {
        door_px = vertical.bottom_px.x();
        door_weight = 0;
      }
      const double weight = vertical.weight * (1 - 0.5 * std::abs(beneath) / kFootTolerance);
      foot.feet += std::max(0.0, weight - door_weight);
      door_weight = std::max(door_weight, weight);
    } else if (beneath > kCrossingMin) {
      const double above =
          contrast_along(view, vertical, vertical.top_px.y(), v_px - kFootTolerance * height_px_);
      const double below =
          contrast_along(view, vertical, v_px + kFootTolerance * height_px_, vertical.bottom_px.y());
      if (below < kReflection * above) continue;
      const double length =
          std::min(1.0, (vertical.bottom_px.y() - vertical.top_px.y()) / (0.3 * height_px_));
      const double aside = (vertical.bottom_px.x() - vanishing_point_px_.x()) / width_px_;
      foot.crossings +=
          std::min(1.0, aside / 0.15) * length * std::min(1.0, below / 25) * std::min(1.0, beneath / 0.15);
    }
  }
}

/// Mean step across a vertical line between two rows.
double WallFootSearch::contrast_along(const SideView& view, const SideVertical& vertical, double from_px,
                                      double to_px) const {
  constexpr int kBeside_px = 2;
  constexpr double kStep_px = 4;
  const Vec2 down = vertical.bottom_px - vertical.top_px;
  double sum = 0;
  int count = 0;
  const int steps = steps_within(to_px - from_px, kStep_px);
  for (int i = 0; i <= steps; ++i) {
    const double v_px = from_px + i * kStep_px;
    const double u_px = vertical.top_px.x() + down.x() * (v_px - vertical.top_px.y()) / down.y();
    const int u = static_cast<int>(std::lround(u_px)), v = static_cast<int>(std::lround(v_px));
    if (!view.contains(u - kBeside_px, v) || !view.contains(u + kBeside_px, v)) continue;
    sum += std::abs(view.at(u + kBeside_px, v) - view.at(u - kBeside_px, v));
    ++count;
  }
  return count == 0 ? 0 : sum / count;
}

void WallFootSearch::measure_floor_side(const SideView& view, WallFoot& foot) const {
  constexpr double kStep_px = 6, kBeside_px = 4, kLookStep_px = 3;
  const Vec2 beneath = kBeside_px * left_normal(foot.direction);
  int count = 0, followed = 0;
  const int steps = steps_within(foot.to_px - foot.from_px, kStep_px);
  for (int i = 0; i <= steps; ++i) {
    const double along = foot.from_px + i * kStep_px;
    const Vec2 on = foot.point_px + along * foot.direction;
    const Vec2 lower = on + beneath, upper = on - beneath;
    const int row = static_cast<int>(std::lround(on.y()));
    const int lu = static_cast<int>(std::lround(lower.x())), lv = static_cast<int>(std::lround(lower.y()));
    const int uu = static_cast<int>(std::lround(upper.x())), uv = static_cast<int>(std::lround(upper.y()));
    if (!view.contains(lu, lv) || !view.contains(uu, uv)) continue;
    const int own = std::abs(view.at(lu, lv) - view.at(uu, uv));
    const double reach_px = std::min(0.16 * width_px_, 0.6 * std::abs(on.x() - vanishing_point_px_.x()));
    const int step = static_cast<int>(std::lround(kFloorStep_px * width_px_ / 640));
    int greatest = 0;
    const double nearest_px = 0.025 * width_px_;
    const int looks = steps_within(reach_px - nearest_px, kLookStep_px);
    for (int look = 0; look <= looks; ++look) {
      const double aside = nearest_px + look * kLookStep_px;
      const int u = static_cast<int>(std::lround(on.x() - aside));
      if (!view.contains(u, row) || !view.contains(u - step, row)) break;
      greatest = std::max(greatest, std::abs(view.at(u, row) - view.at(u - step, row)));
    }
    ++count;
    if (greatest > std::max(18.0, 0.8 * own)) ++followed;
  }
  if (count > 0) foot.followed = static_cast<double>(followed) / count;
}

void WallFootSearch::measure_floor(const SideView& view, WallFoot& foot) const {
  constexpr double kStep_px = 6;
  const Vec2 beneath = floor_->cell_px() * left_normal(foot.direction);
  const auto is_seen = [&](const Vec2& p) {
    return view.contains(static_cast<int>(std::lround(p.x())), static_cast<int>(std::lround(p.y())));
  };
  int count = 0, on_floor = 0, at_edge = 0;
  const int steps = steps_within(foot.to_px - foot.from_px, kStep_px);
  for (int i = 0; i <= steps; ++i) {
    const Vec2 on = foot.point_px + (foot.from_px + i * kStep_px) * foot.direction;
    const Vec2 near = on + kFloorBeside * beneath, far = on + kFloorBeneathBoard * beneath;
    const Vec2 upper = on - kFloorBeside * beneath;
    if (!is_seen(near) || !is_seen(upper)) continue;
    ++count;
    if (!floor_->contain(view, near) && !(is_seen(far) && floor_->contain(view, far))) continue;
    ++on_floor;
    if (!floor_->contain(view, upper)) ++at_edge;
  }
  if (count == 0) return;
  foot.on_floor = static_cast<double>(on_floor) / count;
  foot.at_edge = static_cast<double>(at_edge) / count;
}

/// A skirting board has two edges; the lower one is at the floor.
const WallFoot* WallFootSearch::lowest_of_like_score(double score_min) const {
  const auto better = [](const WallFoot& a, const WallFoot& b) { return a.score() < b.score(); };
  const auto best_at = std::max_element(feet_.begin(), feet_.end(), better);
  if (best_at == feet_.end() || best_at->score() < score_min) return nullptr;
  const WallFoot* best = &*best_at;
  for (int board = 0; board < kBoards; ++board) {
    const WallFoot* lowest = best;
    for (const WallFoot& foot : feet_) {
      if (is_lower_edge(foot, *best) && (lowest == best || depth_px(foot) > depth_px(*lowest)))
        lowest = &foot;
    }
    if (lowest == best) break;
    best = lowest;
  }
  return best;
}

/// Whether `foot` may be the lower edge of the board whose upper edge is `upper`.
bool WallFootSearch::is_lower_edge(const WallFoot& foot, const WallFoot& upper) const {
  const bool opposite_step = foot.support() > kOtherEdge * upper.support() && foot.followed < kFreeFloor &&
                             foot.sign * upper.sign < 0;
  if (foot.score() < kLikeScore * upper.score() && !opposite_step) return false;
  return depth_px(foot) > depth_px(upper) + kBoardMin * width_px_ &&
         depth_px(foot) < kBoardDepthMax * depth_px(upper);
}

/// How far beneath the vanishing point a line is in a column to the right of it.
double WallFootSearch::depth_px(const WallFoot& foot) const {
  return foot.v_at(vanishing_point_px_.x() + kDepthAside * width_px_) - vanishing_point_px_.y();
}

}  // namespace aisle
