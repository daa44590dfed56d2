#include "aisle/localisation/pose_search.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace aisle {
namespace {

constexpr double kSure_m = 0.12;  // hits this near to a surface are as likely as can be
constexpr double kUnlikely_m = 0.35;
constexpr int kTopLevel = 5;
constexpr int kFinerPerCell = 2;  // cells of the field along one of the pyramid

static_assert(LikelihoodPyramid::kCell_m == kFinerPerCell * SurfaceField::kCell_m);

std::uint8_t likelihood_at(double distance_m) {
  const double share = std::clamp((kUnlikely_m - distance_m) / (kUnlikely_m - kSure_m), 0.0, 1.0);
  return static_cast<std::uint8_t>(std::lround(LikelihoodPyramid::kLikely * share));
}

/// The level whose windows are at least so wide.
int level_of(int cells) {
  return std::min(static_cast<int>(std::bit_width(static_cast<unsigned>(cells - 1))),
                  LikelihoodPyramid::kLevels - 1);
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

void LikelihoodPyramid::grow(Levels& levels) const {
  for (int level = 1; level < kLevels; ++level) {
    const int half = 1 << (level - 1);
    for (int y = -kPadding; y < rows_; ++y) {
      for (int x = -kPadding; x < columns_; ++x) {
        const int most =
            std::max(std::max(at(levels, level - 1, x, y), at(levels, level - 1, x + half, y)),
                     std::max(at(levels, level - 1, x, y + half), at(levels, level - 1, x + half, y + half)));
        levels[static_cast<std::size_t>(level)][index(x, y)] = static_cast<std::uint8_t>(most);
      }
    }
  }
}

PoseSearch::PoseSearch(const LikelihoodPyramid& map, std::span<const Vec2> hits, double score_min)
    : map_(map), hits_(hits.size()), score_min_(score_min) {
  turn_hits(hits);
  const int window = 1 << kTopLevel;
  for (int heading = 0; heading < kHeadings; ++heading) {
    for (int y = 0; y < map.rows(); y += window) {
      for (int x = 0; x < map.columns(); x += window) add({0, x, y, heading, kTopLevel});
    }
  }
}

void PoseSearch::turn_hits(std::span<const Vec2> hits) {
  hits_turned_.reserve(hits_ * kHeadings);
  for (int heading = 0; heading < kHeadings; ++heading) {
    const Mat2 turn = rotation(heading * kHeadingStep_rad);
    for (const Vec2& hit : hits) {
      const Vec2 cells = (turn * hit) / LikelihoodPyramid::kCell_m;
      hits_turned_.push_back({static_cast<std::int16_t>(std::floor(cells.x() + 0.5)),
                              static_cast<std::int16_t>(std::floor(cells.y() + 0.5)),
                              static_cast<std::int16_t>(cells.norm() * kHeadingStep_rad / 2)});
    }
  }
}

/// The greatest score that a pose of the node may have; something less than `score_min_` if it is less.
double PoseSearch::bound(const Node& node) const {
  const int whole = static_cast<int>(hits_) * LikelihoodPyramid::kLikely;
  const int least = static_cast<int>(score_min_ * whole);
  const Hit* const hits = &hits_turned_[static_cast<std::size_t>(node.heading) * hits_];
  const int window = 1 << node.level;
  int lost = 0, spread = 0, level = node.level;
  for (std::size_t i = 0; i < hits_; ++i) {
    const Hit& hit = hits[i];
    if (hit.spread != spread) {
      spread = hit.spread;
      level = level_of(window + 2 * spread);
    }
    lost += LikelihoodPyramid::kLikely -
            map_.likelihood(level, node.x + hit.x - hit.spread, node.y + hit.y - hit.spread);
    if (whole - lost < least) return -1;
  }
  return static_cast<double>(whole - lost) / whole;
}

void PoseSearch::add(Node node) {
  if (!map_.can_stand(node.level, node.x, node.y)) return;
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
    const int half = 1 << (node.level - 1);
    for (int k = 0; k < 4; ++k)
      add({0, node.x + k % 2 * half, node.y + k / 2 * half, node.heading, node.level - 1});
  }
  return std::nullopt;
}

}  // namespace aisle
