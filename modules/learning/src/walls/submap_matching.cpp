#include "walls/submap_matching.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "aisle/core/square.hpp"
#include "aisle/matching/signature.hpp"

namespace aisle {
namespace {

constexpr SignatureParams kSignature = {.reach_m = 0, .cell_m = 0.04, .neighbourhood = 6, .tolerance = 2};
constexpr double kSignatureEndWeight = 0.3;
constexpr double kSignatureCap_m = 4;  // longer walls get no more weight
constexpr double kParallel = 0.99;     // |cos| of the angle between two normals: within 8 degrees
constexpr double kAxesApart = 0.85;    // |cos|: the second direction is at least 32 degrees from the first
constexpr double kSubmapTurnMax_rad = 12 * kDegree;
constexpr double kTurnBin_rad = 1 * kDegree;
constexpr std::size_t kTurns = 4;
constexpr int kSubmapPeaks = 6;
constexpr double kSubmapPeaksApart_m = 0.16;
constexpr double kScoreGate_m = 0.15;
constexpr double kScoreCap_m = 3;
constexpr double kComparedMin_m = 2;  // with less wall to compare, nothing can be said
constexpr double kRivalApart_m = 0.3;
constexpr double kObliqueHeading_rad = 6 * kDegree;
constexpr double kCommonMin_m = 0.05;
constexpr int kRefinements = 5;
constexpr double kOffsetSigma_m = 0.03;
constexpr double kMatchCauchy_m = 0.05;
constexpr double kMatchHeadingSigma_rad = 1.5 * kDegree;
constexpr double kPriorSigma_m = 1;
constexpr double kPriorSigma_rad = 1 * kDegree;

double coordinate(const WallEstimate& wall) {
  return wall.normal.dot(wall.anchor);
}

/// Two directions along which the walls' signatures show a displacement.
struct Axes {
  Vec2 first = Vec2::UnitX();
  Vec2 second = Vec2::UnitY();
  bool orthogonal = true;  ///< the map's axes, marked only by the walls on them

  /// The displacement with these two components.
  Vec2 displacement(double along_first_m, double along_second_m) const {
    Mat2 rows;
    rows << first.transpose(), second.transpose();
    return rows.inverse() * Vec2(along_first_m, along_second_m);
  }
};

/// The normal with the most wall length, clearly different from another one if given; nullopt if there is
/// none.
std::optional<Vec2> commonest_normal(std::span<const WallEstimate> walls, const Vec2* apart_from) {
  std::optional<Vec2> best;
  double best_m = 0;
  for (const WallEstimate& seed : walls) {
    if (apart_from && std::abs(seed.normal.dot(*apart_from)) > kAxesApart) continue;
    double parallel_m = 0;
    for (const WallEstimate& wall : walls) {
      if (std::abs(wall.normal.dot(seed.normal)) > kParallel)
        parallel_m += std::min(wall.length_m(), kSignatureCap_m);
    }
    if (parallel_m > best_m) {
      best_m = parallel_m;
      best = seed.normal;
    }
  }
  return best;
}

/// The map's axes; in a building without axes, the two most common directions of the walls.
Axes axes_of(std::span<const WallEstimate> walls) {
  if (std::any_of(walls.begin(), walls.end(), [](const WallEstimate& w) { return !w.is_oblique(); }))
    return {};
  const auto first = commonest_normal(walls, nullptr);
  const auto second = first ? commonest_normal(walls, &*first) : std::nullopt;
  return second ? Axes{*first, *second, false} : Axes{};
}

Signature signature_of(std::span<const WallEstimate> walls, const Vec2& axis, bool orthogonal) {
  Signature signature;
  for (const WallEstimate& wall : walls) {
    if (orthogonal && wall.is_oblique()) continue;
    mark({wall.segment(), std::min(wall.length_m(), kSignatureCap_m), kSignatureEndWeight,
          kSignatureEndWeight},
         axis, SymbolKinds::kByFacing, signature);
  }
  return signature;
}

/// Zero displacement, and the peaks of the signatures' correlation along one axis.
std::vector<double> likely_displacements(std::span<const WallEstimate> fresh,
                                         std::span<const WallEstimate> old, const Vec2& axis, bool orthogonal,
                                         SignatureCorrelator& correlator) {
  Signature learned = signature_of(old, axis, orthogonal);
  sort_symbols(learned);
  std::vector<double> displacements_m = {0};
  correlator.correlate(signature_of(fresh, axis, orthogonal), learned);
  correlator.peaks_m(kSubmapPeaks, kSubmapPeaksApart_m, displacements_m);
  return displacements_m;
}

/// Share of the fresh walls' length, inside the known area, that lies on old walls.
SubmapFit score(std::span<const WallEstimate> fresh, const WallPattern& old, const KnownArea& known,
                const Vec2& displacement_m) {
  SubmapFit fit;
  fit.displacement_m = displacement_m;
  double compared_m = 0, common_m = 0;
  for (const WallEstimate& wall : fresh) {
    if (!known.contains(wall.middle() + displacement_m)) continue;
    const double length_m = wall.length_m();
    const double capped_m = std::min(length_m, kScoreCap_m);
    compared_m += capped_m;
    const WallPattern::Hit hit = old.hit(wall, displacement_m, kScoreGate_m);
    if (!hit.wall) continue;
    const double counted_m = hit.common_m * capped_m / length_m;
    common_m += counted_m;
    fit.matched_m[0] += counted_m * std::abs(wall.normal.x());
    fit.matched_m[1] += counted_m * std::abs(wall.normal.y());
  }
  fit.score = compared_m > kComparedMin_m ? common_m / compared_m : 0;
  return fit;
}

}  // namespace

WallPattern::WallPattern(std::vector<WallEstimate> walls) : walls_(std::move(walls)) {
  std::stable_sort(walls_.begin(), walls_.end(), [](const WallEstimate& a, const WallEstimate& b) {
    return a.facing != b.facing ? a.facing < b.facing : coordinate(a) < coordinate(b);
  });
  for (const WallEstimate& wall : walls_) {
    coordinates_.push_back(coordinate(wall));
    ++first_of_facing_[static_cast<std::size_t>(wall.facing) + 1];
  }
  for (std::size_t f = 1; f < std::size(first_of_facing_); ++f)
    first_of_facing_[f] += first_of_facing_[f - 1];
}

WallPattern::Hit WallPattern::hit(const WallEstimate& wall, const Vec2& displacement_m, double gate_m) const {
  const auto facing = static_cast<std::size_t>(wall.facing);
  std::size_t first = first_of_facing_[facing], end = first_of_facing_[facing + 1];
  const Vec2 middle = wall.middle() + displacement_m;
  if (!wall.is_oblique()) {
    const double across = wall.normal.dot(middle);
    const auto begin = coordinates_.begin();
    const auto low = std::lower_bound(begin + static_cast<std::ptrdiff_t>(first),
                                      begin + static_cast<std::ptrdiff_t>(end), across - gate_m);
    const auto high = std::upper_bound(low, begin + static_cast<std::ptrdiff_t>(end), across + gate_m);
    first = static_cast<std::size_t>(low - begin);
    end = static_cast<std::size_t>(high - begin);
  }
  const Segment2 segment{wall.segment().start + displacement_m, wall.segment().end + displacement_m};
  const double length_m = wall.length_m();
  Hit best;
  for (std::size_t k = first; k < end; ++k) {
    const WallEstimate& old = walls_[k];
    if (old.is_oblique() && std::abs(wrap_angle(wall.heading_rad - old.heading_rad)) > kObliqueHeading_rad)
      continue;
    const double off_m = std::abs(old.offset_of(middle));
    if (off_m > gate_m) continue;
    const double overlap_m = old.extent.overlap(old.span_of(segment));
    if (overlap_m <= kCommonMin_m) continue;
    const double common_m = std::min(overlap_m, length_m) * (1 - 0.5 * off_m / gate_m);
    if (common_m > best.common_m) best = {&old, common_m};
  }
  return best;
}

SubmapFit fit_submap(std::span<const WallEstimate> fresh, const WallPattern& old, const KnownArea& known,
                     double reach_m) {
  SignatureParams params = kSignature;
  params.reach_m = reach_m;
  SignatureCorrelator correlator(params);
  const Axes axes = axes_of(fresh);
  const auto first_m = likely_displacements(fresh, old.walls(), axes.first, axes.orthogonal, correlator);
  const auto second_m = likely_displacements(fresh, old.walls(), axes.second, axes.orthogonal, correlator);

  std::vector<SubmapFit> fits;
  for (const double along_first_m : first_m) {
    for (const double along_second_m : second_m) {
      fits.push_back(score(fresh, old, known, axes.displacement(along_first_m, along_second_m)));
    }
  }
  const auto by_score = [](const SubmapFit& a, const SubmapFit& b) { return a.score < b.score; };
  SubmapFit best = *std::max_element(fits.begin(), fits.end(), by_score);
  for (const SubmapFit& fit : fits) {
    const bool is_elsewhere = (fit.displacement_m - best.displacement_m).norm() > kRivalApart_m;
    if (is_elsewhere) best.rival_score = std::max(best.rival_score, fit.score);
  }
  return best;
}

std::vector<double> likely_turns(std::span<const WallEstimate> fresh, std::span<const WallEstimate> old) {
  std::vector<double> turns = {0};
  if (std::any_of(fresh.begin(), fresh.end(), [](const WallEstimate& w) { return !w.is_oblique(); }))
    return turns;
  constexpr auto kTurnBins = static_cast<std::size_t>(2 * kSubmapTurnMax_rad / kTurnBin_rad);
  std::array<double, kTurnBins> votes{};
  for (const WallEstimate& a : fresh) {
    for (const WallEstimate& b : old) {
      const double turn = wrap_angle(b.heading_rad - a.heading_rad);
      if (std::abs(turn) >= kSubmapTurnMax_rad) continue;
      votes[static_cast<std::size_t>((turn + kSubmapTurnMax_rad) / kTurnBin_rad)] +=
          std::min({a.length_m(), b.length_m(), kSignatureCap_m});
    }
  }
  while (turns.size() < kTurns) {
    const auto top = std::max_element(votes.begin(), votes.end());
    if (*top <= 0) break;
    const auto bin = static_cast<std::size_t>(top - votes.begin());
    turns.push_back((static_cast<double>(bin) + 0.5) * kTurnBin_rad - kSubmapTurnMax_rad);
    for (std::size_t i = bin > 0 ? bin - 1 : 0; i <= std::min(kTurnBins - 1, bin + 1); ++i) votes[i] = 0;
  }
  return turns;
}

RefinedFit refine_fit(const Submap& submap, const Pose2& T_map_anchor, const WallPattern& old,
                      const KnownArea& known) {
  RefinedFit fit{T_map_anchor, Mat3::Zero()};
  std::vector<WallEstimate> fresh;
  for (int round = 0; round < kRefinements; ++round) {
    fresh.clear();
    place_walls(submap, fit.T_map_anchor, fresh);
    const double turned = wrap_angle(fit.T_map_anchor.theta - T_map_anchor.theta);
    fit.information = Mat3::Zero();
    Vec3 gradient = Vec3::Zero();
    for (const WallEstimate& wall : fresh) {
      if (!known.contains(wall.middle())) continue;
      const WallPattern::Hit hit = old.hit(wall, Vec2::Zero(), round < 2 ? kScoreGate_m : 0.1);
      if (!hit.wall) continue;
      const double common_m = std::min({1.0, wall.length_m(), hit.wall->length_m()});
      const double offset_m = hit.wall->offset_of(wall.middle());
      const double heading = wall.is_oblique() ? wall.heading_rad : wall.heading_rad + turned;
      const double turn = wrap_angle(heading - hit.wall->heading_rad);
      const double offset_weight =
          common_m / square(kOffsetSigma_m) / (1 + square(offset_m / kMatchCauchy_m));
      const double heading_weight = common_m / square(kMatchHeadingSigma_rad);
      // A wall that stays on its axis through a turn keeps the distance of the point that turned: its anchor.
      const Vec2 lever = (wall.is_oblique() ? wall.middle() : wall.anchor) - fit.T_map_anchor.position();
      const Vec3 jacobian(hit.wall->normal.x(), hit.wall->normal.y(),
                          hit.wall->normal.dot(left_normal(lever)));
      fit.information += offset_weight * jacobian * jacobian.transpose();
      gradient += offset_weight * offset_m * jacobian;
      fit.information(2, 2) += heading_weight;
      gradient(2) += heading_weight * turn;
    }
    Mat3 damped = fit.information;
    damped.diagonal() += Vec3::Constant(1 / square(kPriorSigma_m));
    damped(2, 2) += 1 / square(kPriorSigma_rad);
    gradient(2) += turned / square(kPriorSigma_rad);
    const Vec3 step = -damped.ldlt().solve(gradient);
    fit.T_map_anchor.x += step(0);
    fit.T_map_anchor.y += step(1);
    fit.T_map_anchor.theta = wrap_angle(fit.T_map_anchor.theta + step(2));
  }
  return fit;
}

}  // namespace aisle
