#include "walls/relocation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/matching/signature.hpp"

namespace aisle {
namespace {

constexpr double kRecent_m = 6;  // walls seen within this path length, at least twice, are trusted
constexpr double kLong_m = 0.5;  // segments and walls at least this long vote for a heading
constexpr double kRelocationTurnMax_rad = 45 * kDegree;
constexpr double kBin_rad = 2 * kDegree;
constexpr std::size_t kBins = 90;
constexpr int kHeadings = 5;
constexpr int kRelocationPeaks = 3;
constexpr double kSeenEndWeight = 0.2;
constexpr double kVoteLengthCap_m = 3;  // longer walls get no more weight
constexpr double kGate_m = 0.35;
constexpr double kHitGate_m = 0.08;
constexpr double kHitGate_rad = 3 * kDegree;
constexpr double kOnWallsMin = 0.5;
constexpr double kOnWallsGainMin = 0.15;
constexpr double kGainMin = 0.2;
constexpr double kAxisBonus = 0.4;     // without effect in a building without axes
constexpr double kCostPerMetre = 0.1;  // a near pose wins over an equal one far off
constexpr double kCostPerDegree = 0.004;

std::vector<int> trusted(std::span<const WallEstimate> walls, std::span<const int> window, double path_m) {
  std::vector<int> ids;
  for (const int id : window) {
    const WallEstimate& wall = walls[static_cast<std::size_t>(id)];
    if (path_m - wall.last_seen_m < kRecent_m && wall.sightings >= 2) ids.push_back(id);
  }
  return ids;
}

/// Turns that align the most segment length with walls' headings; no turn is always among them.
std::vector<double> likely_turns(double heading_rad, std::span<const SensedSegment> segments,
                                 std::span<const WallEstimate> walls, std::span<const int> ids) {
  std::array<double, kBins> votes{};
  for (const SensedSegment& s : segments) {
    if (s.length_m <= kLong_m) continue;
    for (const int id : ids) {
      const WallEstimate& wall = walls[static_cast<std::size_t>(id)];
      const double turn = wrap_angle(wall.heading_rad - heading_rad - s.heading_rad);
      if (wall.length_m() <= kLong_m || std::abs(turn) > kRelocationTurnMax_rad) continue;
      votes[static_cast<std::size_t>(turn / kBin_rad + kBins / 2.0)] += std::min(s.length_m, wall.length_m());
    }
  }
  std::array<double, kBins> smooth{};
  for (std::size_t i = 1; i + 1 < kBins; ++i) smooth[i] = 0.5 * votes[i - 1] + votes[i] + 0.5 * votes[i + 1];

  std::vector<double> turns = {0};
  for (std::size_t i = kBins / 2 - 2; i <= kBins / 2 + 1; ++i) smooth[i] = 0;
  while (turns.size() < kHeadings) {
    const auto top = std::max_element(smooth.begin(), smooth.end());
    if (*top <= 0) break;
    const auto bin = static_cast<std::size_t>(top - smooth.begin());
    turns.push_back((static_cast<double>(bin) + 0.5 - kBins / 2.0) * kBin_rad);
    for (std::size_t i = bin > 2 ? bin - 2 : 0; i <= std::min(kBins - 1, bin + 2); ++i) smooth[i] = 0;
  }
  return turns;
}

/// Displacements along one axis proposed by signature matching; none is always among them.
std::vector<double> likely_displacements(const Vec2& axis, const Pose2& T_map_sensor,
                                         std::span<const SensedSegment> segments,
                                         std::span<const WallEstimate> walls, std::span<const int> ids,
                                         double reach_m) {
  Signature sensed, learned;
  for (const SensedSegment& s : segments) {
    mark({T_map_sensor * s.segment, s.length_m, kSeenEndWeight, kSeenEndWeight}, axis, SymbolKinds::kByFacing,
         sensed);
  }
  for (const int id : ids) {
    const WallEstimate& wall = walls[static_cast<std::size_t>(id)];
    const double length_weight = std::min(wall.length_m(), kVoteLengthCap_m);
    mark({wall.segment(), length_weight, kSeenEndWeight, kSeenEndWeight}, axis, SymbolKinds::kByFacing,
         learned);
  }
  sort_symbols(learned);
  SignatureCorrelator correlator({reach_m, 0.03, 6, 2});
  std::vector<double> displacements_m = {0};
  correlator.correlate(sensed, learned);
  correlator.peaks_m(kRelocationPeaks, 0.18, displacements_m);
  return displacements_m;
}

struct Score {
  double on_walls = 0;  ///< share of the seen length that lies close to walls
  double total = 0;     ///< score: more for length along the axes, less for distance from the guess
};

Score score(const Pose2& pose, const Pose2& guess, std::span<const SensedSegment> segments,
            std::span<const WallEstimate> walls, std::span<const int> ids) {
  double hit_m = 0, along_axes_m = 0, seen_m = 0;
  for (const SensedSegment& s : segments) {
    seen_m += s.length_m;
    const AssociationGate gate{kHitGate_m, kHitGate_rad, 0.3 * s.length_m};
    const PlacedSegment placed(s, pose);
    if (associate(placed, walls, ids, gate) >= 0) hit_m += s.length_m;
    if (facing_of(placed.heading_rad, kHitGate_rad) != Facing::kOblique) along_axes_m += s.length_m;
  }
  const double distance_cost = kCostPerMetre * (pose.position() - guess.position()).norm() +
                               kCostPerDegree * to_degrees(std::abs(wrap_angle(pose.theta - guess.theta)));
  return {hit_m / seen_m, (hit_m + kAxisBonus * along_axes_m) / seen_m - distance_cost};
}

}  // namespace

std::optional<Pose2> find_pose_near(const Pose2& guess, std::span<const SensedSegment> segments,
                                    std::span<const WallEstimate> walls, std::span<const int> window,
                                    double path_m, double reach_m, PoseAligner& aligner) {
  const std::vector<int> ids = trusted(walls, window, path_m);
  if (ids.size() < 3) return std::nullopt;
  const Vec3 prior_sigma(0.5, 0.5, 5 * kDegree);
  const Mat3 prior_information = prior_sigma.cwiseAbs2().cwiseInverse().asDiagonal();
  const Score present = score(guess, guess, segments, walls, ids);
  double best_total = present.total + kGainMin;
  std::optional<Pose2> best;
  for (const double turn : likely_turns(guess.theta, segments, walls, ids)) {
    const Pose2 turned{guess.x, guess.y, wrap_angle(guess.theta + turn)};
    const auto x_candidates_m = likely_displacements(Vec2::UnitX(), turned, segments, walls, ids, reach_m);
    const auto y_candidates_m = likely_displacements(Vec2::UnitY(), turned, segments, walls, ids, reach_m);
    for (const double x_m : x_candidates_m) {
      for (const double y_m : y_candidates_m) {
        const Pose2 start{turned.x + x_m, turned.y + y_m, turned.theta};
        const Pose2 pose =
            aligner.align(segments, walls, ids, {start, prior_information}, kGate_m, 5).T_map_sensor;
        const Score fit = score(pose, guess, segments, walls, ids);
        if (fit.total <= best_total ||
            fit.on_walls < std::max(kOnWallsMin, present.on_walls + kOnWallsGainMin))
          continue;
        best_total = fit.total;
        best = pose;
      }
    }
  }
  return best;
}

}  // namespace aisle
