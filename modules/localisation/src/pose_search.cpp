#include "aisle/localisation/pose_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace aisle {
namespace {

constexpr double kSure_m = 0.12;  // hits this near to a surface are as likely as can be
constexpr double kUnlikely_m = 0.25;
constexpr std::array kHeadingsOfLevel{1, 1, 2, 4, 8, 8};  // of a node; each a divisor of the next
constexpr int kTopLevel = static_cast<int>(kHeadingsOfLevel.size()) - 1;
constexpr int kFinerPerCell = 2;  // cells of the field along one of the pyramid

static_assert(PoseSearch::kHeadings % kHeadingsOfLevel.back() == 0);
static_assert(LikelihoodPyramid::kCell_m == kFinerPerCell * SurfaceField::kCell_m);

std::uint8_t likelihood_at(double distance_m) {
  const double share = std::clamp((kUnlikely_m - distance_m) / (kUnlikely_m - kSure_m), 0.0, 1.0);
  return static_cast<std::uint8_t>(std::lround(LikelihoodPyramid::kLikely * share));
}

}  // namespace

LikelihoodPyramid::LikelihoodPyramid(const SurfaceField& field)
    : p_map_corner_(field.corner_m()),
      columns_((field.columns() + kFinerPerCell - 1) / kFinerPerCell),
      rows_((field.rows() + kFinerPerCell - 1) / kFinerPerCell) {
  const auto cells =
      static_cast<std::size_t>(columns_ + kPadding) * static_cast<std::size_t>(rows_ + kPadding);
  likelihoods_.assign(kLevels, std::vector<std::uint8_t>(cells));
  can_stand_.assign(kLevels, std::vector<std::uint8_t>(cells));
  for (int y = 0; y < rows_; ++y) {
    for (int x = 0; x < columns_; ++x) {
      likelihoods_[0][index(x, y)] = likelihood_at(field.distance_m(centre(x, y)));
      for (int k = 0; k < kFinerPerCell * kFinerPerCell; ++k) {
        const Vec2 p =
            field.centre(kFinerPerCell * x + k % kFinerPerCell, kFinerPerCell * y + k / kFinerPerCell);
        if (field.can_stand(p)) can_stand_[0][index(x, y)] = 1;
      }
    }
  }
  grow(likelihoods_);
  grow(can_stand_);
}

std::optional<int> LikelihoodPyramid::level_of(int width) {
  const auto level = std::lower_bound(kWidths.begin(), kWidths.end(), width);
  if (level == kWidths.end()) return std::nullopt;
  return static_cast<int>(level - kWidths.begin());
}

/// Each window from four of the level below, which overlap.
void LikelihoodPyramid::grow(Levels& levels) const {
  for (int level = 1; level < kLevels; ++level) {
    const auto l = static_cast<std::size_t>(level);
    const int step = kWidths[l] - kWidths[l - 1];
    for (int y = -kPadding; y < rows_; ++y) {
      for (int x = -kPadding; x < columns_; ++x) {
        const int most =
            std::max(std::max(at(levels, level - 1, x, y), at(levels, level - 1, x + step, y)),
                     std::max(at(levels, level - 1, x, y + step), at(levels, level - 1, x + step, y + step)));
        levels[l][index(x, y)] = static_cast<std::uint8_t>(most);
      }
    }
  }
}

PoseSearch::PoseSearch(const LikelihoodPyramid& map, std::span<const Vec2> hits, double score_min)
    : map_(map), hits_(hits.size()), score_min_(score_min) {
  turn_hits(hits);
  const int window = 1 << kTopLevel;
  for (int heading = 0; heading < kHeadings; heading += kHeadingsOfLevel[kTopLevel]) {
    for (int y = 0; y < map.rows(); y += window) {
      for (int x = 0; x < map.columns(); x += window) add({0, x, y, heading, kTopLevel});
    }
  }
}

void PoseSearch::turn_hits(std::span<const Vec2> hits) {
  hits_turned_.reserve(2 * hits_ * kHeadings);
  for (int half_step = 0; half_step < 2 * kHeadings; ++half_step) {
    const Mat2 turn = rotation(half_step * kHeadingStep_rad / 2);
    for (const Vec2& hit : hits) {
      const Vec2 cells = (turn * hit) / LikelihoodPyramid::kCell_m;
      hits_turned_.push_back({static_cast<std::int16_t>(std::floor(cells.x() + 0.5)),
                              static_cast<std::int16_t>(std::floor(cells.y() + 0.5))});
    }
  }
  reaches_.reserve(kHeadingsOfLevel.size() * hits_);
  for (int level = 0; level <= kTopLevel; ++level) {
    const int headings = kHeadingsOfLevel[static_cast<std::size_t>(level)];
    for (const Vec2& hit : hits) {
      const double step_cells = hit.norm() / LikelihoodPyramid::kCell_m * kHeadingStep_rad;
      const int spread =
          static_cast<int>(step_cells / 2) + static_cast<int>(std::ceil(step_cells * (headings - 1) / 2));
      reaches_.push_back({spread, LikelihoodPyramid::level_of((1 << level) + 2 * spread)});
    }
  }
}

/// The greatest score that a pose of the node may have; something less than `score_min_` if it is less.
double PoseSearch::bound(const Node& node) const {
  const int whole = static_cast<int>(hits_) * LikelihoodPyramid::kLikely;
  const int least = static_cast<int>(score_min_ * whole);
  const auto level = static_cast<std::size_t>(node.level);
  const auto middle = static_cast<std::size_t>(2 * node.heading + kHeadingsOfLevel[level] - 1);
  const Hit* const hits = &hits_turned_[middle * hits_];
  const Reach* const reaches = &reaches_[level * hits_];
  int lost = 0;
  for (std::size_t i = 0; i < hits_; ++i) {
    const Reach& reach = reaches[i];
    if (!reach.level) continue;
    lost += LikelihoodPyramid::kLikely - map_.likelihood(*reach.level, node.x + hits[i].x - reach.spread,
                                                         node.y + hits[i].y - reach.spread);
    if (whole - lost < least) return -1;
  }
  return static_cast<double>(whole - lost) / whole;
}

void PoseSearch::add(Node node) {
  if (!map_.can_stand(*LikelihoodPyramid::level_of(1 << node.level), node.x, node.y)) return;
  ++nodes_;
  node.score = static_cast<float>(bound(node));
  if (node.score < score_min_) return;
  queue_.push_back(node);
  std::push_heap(queue_.begin(), queue_.end());
}

double PoseSearch::score(int x, int y, int heading) const {
  if (!map_.can_stand(0, x, y)) return 0;
  return std::max(0.0, bound({0, x, y, heading, 0}));
}

std::optional<ScoredPose> PoseSearch::next(double score_min, std::size_t nodes_max) {
  score_min_ = std::max(score_min_, score_min);
  while (!queue_.empty() && nodes_ < nodes_max) {
    std::pop_heap(queue_.begin(), queue_.end());
    const Node node = queue_.back();
    queue_.pop_back();
    if (node.score < score_min_) {
      queue_.clear();
      break;
    }
    if (node.level == 0) {
      const Vec2 p_map = map_.centre(node.x, node.y);
      return ScoredPose{{p_map.x(), p_map.y(), wrap_angle(node.heading * kHeadingStep_rad)}, node.score};
    }
    divide(node);
  }
  return std::nullopt;
}

void PoseSearch::divide(const Node& node) {
  const int half = 1 << (node.level - 1);
  const auto level = static_cast<std::size_t>(node.level);
  for (int turn = 0; turn < kHeadingsOfLevel[level]; turn += kHeadingsOfLevel[level - 1]) {
    for (int k = 0; k < 4; ++k)
      add({0, node.x + k % 2 * half, node.y + k / 2 * half, node.heading + turn, node.level - 1});
  }
}

}  // namespace aisle
