#include "aisle/control/path_fit.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/core/square.hpp"
#include "driven_legs.hpp"
#include "leg_cutting.hpp"
#include "path_adjustment.hpp"

namespace aisle {
namespace {

using Kind = LoosePiece::Kind;

constexpr double kStepsPerRadius = 6;
constexpr double kPrice = 2.5;  // of an arc, for each radius and square of the stray
constexpr int kTries = 3;
constexpr double kCheaper = 4;
constexpr double kBetweenSamples = 0.95;  // of the allowed stray: between samples it may be a little more
constexpr double kStricter = 0.9;
constexpr double kBend_rad = 30 * kDegree;  // hand-driven wander turns less than this over kBendOver_m
constexpr double kBendOver_m = 1.2;
constexpr double kBesideBend_m = 0.5;
constexpr double kMeantStrayShare = 0.4;

double driven_length_m(const DrivenLeg& leg, const PathSegment& path_segment) {
  double length_m = 0;
  for (std::size_t i = path_segment.first; i < path_segment.last; ++i) {
    length_m += (leg.samples[i + 1].position() - leg.samples[i].position()).norm();
  }
  return length_m;
}

/// A driver who turns between walls or reverses chooses the path on purpose: on a bend, beside it and
/// backwards, hardly any of what was driven is wander.
/// @return for each sample of the leg, the share of the maximum stray that is allowed
std::vector<double> stray_shares(const DrivenLeg& leg, double step_m) {
  const std::size_t count = leg.samples.size();
  const auto half = static_cast<std::size_t>(std::max(1L, std::lround(kBendOver_m / 2 / step_m)));
  const auto beside = static_cast<std::size_t>(std::lround(kBesideBend_m / step_m));
  const auto back_from = [](std::size_t i, std::size_t steps) { return i - std::min(i, steps); };
  const auto on_from = [&](std::size_t i, std::size_t steps) { return std::min(i + steps, count - 1); };
  if (leg.gear == Gear::kReverse) return std::vector<double>(count, kMeantStrayShare);
  std::vector<double> shares(count, 1);
  for (std::size_t i = 0; i < count; ++i) {
    const double turn_rad = leg.samples[on_from(i, half)].theta - leg.samples[back_from(i, half)].theta;
    if (std::abs(turn_rad) < kBend_rad) continue;
    for (std::size_t k = back_from(i, beside); k <= on_from(i, beside); ++k) shares[k] = kMeantStrayShare;
  }
  return shares;
}

/// Makes strays count relative to what is allowed.
double first_weight(double stray_share, double step_m) {
  return step_m / square(stray_share);
}

void add_leg(LoosePath& loose, const DrivenLeg& leg, const std::vector<PathSegment>& path_segments,
             double step_m) {
  if (leg.turn_before_rad != 0) {
    loose.pieces.push_back(
        {.kind = Kind::kTurnOnTheSpot, .T_map_start = loose.T_map_end, .turn_rad = leg.turn_before_rad});
  }
  const std::vector<double> shares = stray_shares(leg, step_m);
  for (const PathSegment& path_segment : path_segments) {
    const double length_m = driven_length_m(leg, path_segment);
    loose.pieces.push_back({.kind = path_segment.curvature_per_m == 0 ? Kind::kLine : Kind::kArc,
                            .gear = leg.gear,
                            .T_map_start = leg.samples[path_segment.first],
                            .length_m = length_m,
                            .turn_rad = path_segment.curvature_per_m * length_m,
                            .driven_m = length_m});
    for (std::size_t i = path_segment.first; i < path_segment.last; ++i) {
      loose.driven_points.push_back({.p_map = leg.samples[i].position(),
                                     .piece = loose.pieces.size() - 1,
                                     .stray_share = shares[i],
                                     .weight = first_weight(shares[i], step_m),
                                     .begins_leg = i == 0});
    }
  }
  loose.driven_points.push_back({.p_map = leg.samples.back().position(),
                                 .piece = loose.pieces.size() - 1,
                                 .stray_share = shares.back(),
                                 .weight = first_weight(shares.back(), step_m),
                                 .ends_leg = true});
  loose.T_map_end = leg.samples.back();
}

/// Makes headings continuous over whole turns.
void unwind(std::vector<DrivenLeg>& legs) {
  double heading_rad = legs.front().samples.front().theta;
  for (DrivenLeg& leg : legs) {
    heading_rad += leg.turn_before_rad;
    for (Pose2& sample : leg.samples) {
      heading_rad += wrap_angle(sample.theta - heading_rad);
      sample.theta = heading_rad;
    }
  }
}

LoosePath loose_path(const std::vector<DrivenLeg>& legs, double radius_min_m, double price_m3,
                     double step_m) {
  LoosePath loose;
  for (const DrivenLeg& leg : legs) {
    add_leg(loose, leg, cut_leg(leg.samples, step_m, radius_min_m, price_m3), step_m);
  }
  return loose;
}

/// Distance of a driven point from its piece, divided by the share that is allowed. A leg's last driven point
/// is measured from the piece's end, so that an end that overshoots counts.
double stray_m(const LoosePath& loose, const DrivenPoint& driven_point) {
  const LoosePiece& piece = loose.pieces[driven_point.piece];
  const PathPiece shape{piece.T_map_start, piece.arc()};
  const Vec2 p_map_path =
      (driven_point.ends_leg ? shape.end() : shape.at(shape.nearest(driven_point.p_map, 0, shape.path_m())))
          .position();
  return (p_map_path - driven_point.p_map).norm() / driven_point.stray_share;
}

/// How far the pieces are from joining.
double widest_gap_m(const LoosePath& loose) {
  double widest_m = 0;
  for (std::size_t k = 1; k < loose.pieces.size(); ++k) {
    const Vec2 off_m = loose.pieces[k].T_map_start.position() - loose.pieces[k - 1].end().position();
    widest_m = std::max(widest_m, off_m.norm());
  }
  return widest_m;
}

/// Cuts a piece into two halves that bend independently.
void split(LoosePath& loose, std::size_t k) {
  LoosePiece first = loose.pieces[k];
  first.kind = Kind::kArc;
  first.length_m /= 2;
  first.turn_rad /= 2;
  first.driven_m /= 2;
  LoosePiece second = first;
  second.T_map_start = first.end();
  loose.pieces[k] = first;
  loose.pieces.insert(loose.pieces.begin() + static_cast<std::ptrdiff_t>(k) + 1, second);
  for (DrivenPoint& driven_point : loose.driven_points) {
    const bool in_second = driven_point.piece == k && !driven_point.begins_leg &&
                           (driven_point.ends_leg ||
                            (second.T_map_start.inverse() * driven_point.p_map).x() * sign(first.gear) > 0);
    if (driven_point.piece > k || in_second) ++driven_point.piece;
  }
}

/// The pieces that stray more than every piece near them, so that changing one does not disturb another.
std::vector<std::size_t> worst_of_neighbours(const std::vector<double>& strays_m, double stray_max_m) {
  constexpr std::ptrdiff_t kNear = 4;
  std::vector<std::size_t> worst;
  for (auto stray_m = strays_m.begin(); stray_m != strays_m.end(); ++stray_m) {
    const auto first = stray_m - std::min(kNear, stray_m - strays_m.begin());
    const auto end = stray_m + std::min(kNear + 1, strays_m.end() - stray_m);
    if (*stray_m > stray_max_m && std::max_element(first, end) == stray_m)
      worst.push_back(static_cast<std::size_t>(stray_m - strays_m.begin()));
  }
  return worst;
}

/// Adjusts the pieces, raises the weights where the path strays most, and cuts where that does not help.
/// @param stray_max_m  at the samples
Path smoothed(LoosePath loose, double stray_max_m, double radius_min_m, double step_m) {
  constexpr int kRounds = 24, kPullsBeforeCut = 3;
  constexpr double kPull = 4;
  constexpr double kGapMax = 0.02;  // of the stray: gaps add up where the pieces are laid end to end
  std::vector<double> strays_m;     // the worst of each piece
  for (int round = 1; round <= kRounds; ++round) {
    adjust(loose, radius_min_m);
    strays_m.assign(loose.pieces.size(), 0);
    for (DrivenPoint& driven_point : loose.driven_points) {
      const double off_m = stray_m(loose, driven_point);
      if (off_m > stray_max_m) driven_point.weight *= kPull;
      strays_m[driven_point.piece] = std::max(strays_m[driven_point.piece], off_m);
    }
    const auto worst = worst_of_neighbours(strays_m, stray_max_m);
    if (worst.empty() && widest_gap_m(loose) < kGapMax * stray_max_m) break;
    if (worst.empty() || round % kPullsBeforeCut != 0) continue;
    for (auto k = worst.rbegin(); k != worst.rend(); ++k) split(loose, *k);
    for (DrivenPoint& driven_point : loose.driven_points)
      driven_point.weight = first_weight(driven_point.stray_share, step_m);
  }
  return joined(loose);
}

/// Whether no driven position is farther from the path than allowed, and the path ends where the drive did.
bool keeps_near(const Path& path, std::span<const Pose2> driven, const PathFitParams& params) {
  const double reach_m = params.radius_min_m + params.stray_max_m;
  double along_m = 0;
  for (const Pose2& pose : driven) {
    const PathPoint at = path.nearest(pose.position(), along_m - reach_m / 2, along_m + reach_m);
    if (!((at.T_map_path.position() - pose.position()).norm() <= params.stray_max_m)) return false;
    along_m = std::max(along_m, at.along_m);
  }
  return path.length_m() - along_m <= reach_m;
}

/// From each position straight to the next, with turns on the spot between.
Path from_dot_to_dot(std::span<const Pose2> driven) {
  std::vector<PathPiece> pieces;
  Pose2 T_map_here = driven.front();
  for (const Pose2& pose : driven) {
    const Vec2 step = pose.position() - T_map_here.position();
    if (step.norm() == 0) continue;
    const double towards_rad = heading_of(step);
    const bool backwards = std::abs(wrap_angle(towards_rad - pose.theta)) > kPi / 2;
    const double turn_rad = wrap_angle(towards_rad - T_map_here.theta + (backwards ? kPi : 0));
    pieces.push_back({T_map_here, {0, turn_rad}});
    pieces.push_back({pieces.back().end(), {backwards ? -step.norm() : step.norm(), 0}});
    T_map_here = pieces.back().end();
  }
  return Path(std::move(pieces));
}

}  // namespace

void PathFitParams::describe(FieldList& fields) {
  fields.real("stray_max_m", stray_max_m, {0.005, 1}, "what was driven is at most this far from the path");
  fields.real("radius_min_m", radius_min_m, {0.05, 10}, "of an arc");
}

Path fit_path(std::span<const Pose2> driven, const PathFitParams& params) {
  const bool goes_somewhere = std::any_of(driven.begin(), driven.end(), [&](const Pose2& pose) {
    return pose.position() != driven.front().position();
  });
  if (!goes_somewhere) throw std::invalid_argument("a path needs two different positions");
  double step_m = params.radius_min_m / kStepsPerRadius;
  double price_m3 = kPrice * params.radius_min_m * params.stray_max_m * params.stray_max_m;
  double stray_max_m = kBetweenSamples * params.stray_max_m;
  double radius_min_m = params.radius_min_m;
  for (int tries = 0; tries < kTries; ++tries) {
    std::vector<DrivenLeg> legs = driven_legs(driven, step_m);
    unwind(legs);
    Path path = smoothed(loose_path(legs, radius_min_m, price_m3, step_m), stray_max_m, radius_min_m, step_m);
    if (keeps_near(path, driven, params)) return path;
    stray_max_m *= kStricter;
    price_m3 /= kCheaper;
    radius_min_m /= 2;
    step_m /= 2;
  }
  return from_dot_to_dot(driven);
}

}  // namespace aisle
