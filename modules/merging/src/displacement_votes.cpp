#include "displacement_votes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace aisle {
namespace {

constexpr int kDirections = 720;
constexpr double kDirection_rad = 2 * kPi / kDirections;
constexpr int kBlur = 2;             // directions to either side that a wall counts for
constexpr double kTurnShare = 0.15;  // of the best turn's walls, that another needs
constexpr int kTurnsMax = 24;
constexpr int kTurnsApart = 8;    // directions
constexpr double kCell_m = 0.25;  // longer than a piece: what belongs together falls into four cells
constexpr int kSectors = 36;
constexpr double kSameDirection = 0.99;  // cosine of 8 degrees
constexpr int kStride = 2;  // squares of 2 x 2 cells begin at every cell; of 2 x 2 of them the best

using Spectrum = std::array<double, kDirections>;

int direction_of(const Vec2& normal) {
  const auto direction = static_cast<int>(std::lround(heading_of(normal) / kDirection_rad));
  return (direction % kDirections + kDirections) % kDirections;
}

/// Length of wall by direction.
Spectrum spectrum_of(std::span<const WallSample> samples) {
  Spectrum spectrum{};
  for (const WallSample& sample : samples) {
    for (int i = -kBlur; i <= kBlur; ++i) {
      const int direction = (direction_of(sample.normal) + i + kDirections) % kDirections;
      spectrum[static_cast<std::size_t>(direction)] += sample.length_m * (kBlur + 1 - std::abs(i));
    }
  }
  return spectrum;
}

int sector_of(const Vec2& normal) {
  return direction_of(normal) * kSectors / kDirections;
}

/// The squares of 2 x 2 cells over all displacements at which the two maps touch.
class Votes {
 public:
  Votes(const Eigen::AlignedBox2d& fixed, const Eigen::AlignedBox2d& moved)
      : corner_(fixed.min() - moved.max() - Vec2::Constant(2 * kCell_m)) {
    const Vec2 reach = fixed.sizes() + moved.sizes() + Vec2::Constant(4 * kCell_m);
    columns_ = static_cast<int>(std::ceil(reach.x() / kCell_m)) + 1;
    rows_ = static_cast<int>(std::ceil(reach.y() / kCell_m)) + 1;
    length_m_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
    last_sample_.assign(length_m_.size(), -1);
  }

  /// A piece of wall would lie on another at this displacement. Each piece counts once for a square.
  void add(const Vec2& displacement_m, int sample, double length_m) {
    const Vec2 cells = (displacement_m - corner_) / kCell_m;
    const int x = static_cast<int>(cells.x()), y = static_cast<int>(cells.y());
    for (int k = 0; k < 4; ++k) {
      const std::size_t square = index(x - k % 2, y - k / 2);
      if (last_sample_[square] == sample) continue;
      last_sample_[square] = sample;
      length_m_[square] += static_cast<float>(length_m);
    }
  }

  std::vector<PlacementGuess> best(double turn_rad, double least_m) const {
    std::vector<PlacementGuess> guesses;
    for (int y = 0; y + kStride <= rows_; y += kStride) {
      for (int x = 0; x + kStride <= columns_; x += kStride) {
        int best_x = x, best_y = y;
        for (int k = 1; k < kStride * kStride; ++k) {
          const int other_x = x + k % kStride, other_y = y + k / kStride;
          if (length_m_[index(other_x, other_y)] > length_m_[index(best_x, best_y)])
            best_x = other_x, best_y = other_y;
        }
        const double most_m = length_m_[index(best_x, best_y)];
        if (most_m < least_m) continue;
        const Vec2 middle = corner_ + kCell_m * Vec2(best_x + 1, best_y + 1);
        guesses.push_back({{middle.x(), middle.y(), turn_rad}, most_m});
      }
    }
    return guesses;
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
  }

  Vec2 corner_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<float> length_m_;
  std::vector<int> last_sample_;
};

std::vector<WallSample> turned(std::span<const WallSample> samples, double turn_rad) {
  const Mat2 turn = rotation(turn_rad);
  std::vector<WallSample> result;
  result.reserve(samples.size());
  for (const WallSample& sample : samples)
    result.push_back({turn * sample.p_map, turn * sample.normal, sample.length_m});
  return result;
}

Eigen::AlignedBox2d box_around(std::span<const WallSample> samples) {
  Eigen::AlignedBox2d box;
  for (const WallSample& sample : samples) box.extend(sample.p_map);
  return box;
}

}  // namespace

std::vector<double> likely_turns(std::span<const WallSample> fixed, std::span<const WallSample> moved) {
  const Spectrum a = spectrum_of(fixed), b = spectrum_of(moved);
  Spectrum common{};
  for (std::size_t turn = 0; turn < kDirections; ++turn) {
    for (std::size_t i = 0; i < kDirections; ++i) common[turn] += a[(i + turn) % kDirections] * b[i];
  }
  const double least = kTurnShare * *std::max_element(common.begin(), common.end());
  std::vector<double> turns;
  while (turns.size() < kTurnsMax) {
    const auto best = std::max_element(common.begin(), common.end());
    if (!(*best > 0) || *best < least) break;
    const int turn = static_cast<int>(best - common.begin());
    turns.push_back(wrap_angle(turn * kDirection_rad));
    for (int i = -kTurnsApart; i <= kTurnsApart; ++i)
      common[static_cast<std::size_t>((turn + i + kDirections) % kDirections)] = 0;
  }
  return turns;
}

std::vector<PlacementGuess> likely_displacements(std::span<const WallSample> fixed,
                                                 std::span<const WallSample> moved, double turn_rad,
                                                 double least_m) {
  const std::vector<WallSample> pieces = turned(moved, turn_rad);
  std::array<std::vector<const WallSample*>, kSectors> by_sector;
  for (const WallSample& sample : fixed)
    by_sector[static_cast<std::size_t>(sector_of(sample.normal))].push_back(&sample);
  Votes votes(box_around(fixed), box_around(pieces));
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const WallSample& piece = pieces[i];
    for (int beside = -1; beside <= 1; ++beside) {
      const int sector = (sector_of(piece.normal) + beside + kSectors) % kSectors;
      for (const WallSample* wall : by_sector[static_cast<std::size_t>(sector)]) {
        if (wall->normal.dot(piece.normal) < kSameDirection) continue;
        votes.add(wall->p_map - piece.p_map, static_cast<int>(i), piece.length_m);
      }
    }
  }
  return votes.best(turn_rad, least_m);
}

}  // namespace aisle
