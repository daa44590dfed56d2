#include "aisle/merging/map_alignment.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "aisle/core/cauchy.hpp"
#include "aisle/core/square.hpp"
#include "displacement_votes.hpp"

namespace aisle {
namespace {

constexpr int kSteps = 12;
constexpr int kWideSteps = 5;
constexpr double kWideGate_m = 0.6;  // of the first steps: a guess is off by half a square
constexpr double kGate_m = 0.25;
constexpr double kFaceSigma_m = 0.03;
constexpr double kOneErrorPieces = 5;  // neighbouring pieces share their error: so many count as one
constexpr double kFaceCauchy_m = 0.05;
constexpr double kSettledStep = 1e-5;
constexpr double kHold = 1e-6;  // keeps the matrix invertible along a bare corridor
constexpr std::size_t kKept = 10;

struct NormalEquations {
  Mat3 information = Mat3::Zero();
  Vec3 pull = Vec3::Zero();
};

NormalEquations equations_at(const MapPattern& fixed, const MapPattern& moved, const Pose2& T,
                             double gate_m) {
  NormalEquations equations;
  const Mat2 turn = rotation(T.theta);
  for (const WallSample& sample : moved.samples()) {
    const Vec2 arm = turn * sample.p_map, p = T.position() + arm;
    const Surface* const face = fixed.facing_wall(p, turn * sample.normal);
    if (face == nullptr || face->segment.distance(p) > gate_m) continue;
    const double off_m = face->normal.dot(p - face->segment.start);
    const Vec3 slope(face->normal.x(), face->normal.y(), face->normal.dot(left_normal(arm)));
    const double weight = cauchy_weight(off_m, kFaceCauchy_m) * sample.length_m / MapPattern::kSample_m /
                          (square(kFaceSigma_m) * kOneErrorPieces);
    equations.information += weight * slope * slope.transpose();
    equations.pull -= weight * off_m * slope;
  }
  return equations;
}

class Placements {
 public:
  explicit Placements(const MapAlignmentParams& params) : params_(params) {}

  /// Of two that are the same the better one stays.
  void add(const MapPlacement& placement) {
    const auto known = std::find_if(all_.begin(), all_.end(), [&](const MapPlacement& other) {
      return is_same(other.T_fixed_moved, placement.T_fixed_moved);
    });
    if (known != all_.end() && known->overlap.score_m() >= placement.overlap.score_m()) return;
    if (known != all_.end()) all_.erase(known);
    const auto is_better = [](const MapPlacement& a, const MapPlacement& b) {
      return a.overlap.score_m() > b.overlap.score_m();
    };
    all_.insert(std::upper_bound(all_.begin(), all_.end(), placement, is_better), placement);
  }

  std::vector<MapPlacement>& all() { return all_; }
  double best_score_m() const { return all_.empty() ? 0 : all_.front().overlap.score_m(); }

 private:
  bool is_same(const Pose2& a, const Pose2& b) const {
    return std::abs(wrap_angle(a.theta - b.theta)) < params_.apart_rad &&
           (a.position() - b.position()).norm() < params_.apart_m;
  }

  MapAlignmentParams params_;
  std::vector<MapPlacement> all_;
};

bool is_contradicted(const MapOverlap& overlap, const MapAlignmentParams& params) {
  return overlap.denied_run_m > params.denied_run_max_m;
}

bool is_sound(const MapOverlap& overlap, const MapAlignmentParams& params) {
  return overlap.common_m >= params.common_min_m && overlap.fixing_m() >= params.fixing_min_m &&
         overlap.agreement() >= params.agreement_min &&
         (params.allows_changes || !is_contradicted(overlap, params));
}

/// Believes the best placement, unless something speaks against it or another one is a rival.
void judge(MapAlignment& alignment, const MapAlignmentParams& params) {
  const double best_m = alignment.best().overlap.score_m();
  bool has_rival = false;
  for (auto other = alignment.placements.begin() + 1; other != alignment.placements.end(); ++other) {
    if (other->overlap.agreement() < params.rival_agreement) continue;
    const double share = other->overlap.score_m() / best_m;
    has_rival |=
        share >= (is_contradicted(other->overlap, params) ? params.contradicted_share : params.rival_share);
    alignment.rival_share = std::max(alignment.rival_share, share);
  }
  if (!is_sound(alignment.best().overlap, params))
    alignment.verdict = AlignmentVerdict::kApart;
  else
    alignment.verdict = has_rival ? AlignmentVerdict::kAmbiguous : AlignmentVerdict::kFound;
}

std::vector<PlacementGuess> guesses_for(const MapPattern& fixed, const MapPattern& moved, double least_m) {
  std::vector<PlacementGuess> guesses;
  for (const double turn_rad : likely_turns(fixed.samples(), moved.samples())) {
    const auto some = likely_displacements(fixed.samples(), moved.samples(), turn_rad, least_m);
    guesses.insert(guesses.end(), some.begin(), some.end());
  }
  std::stable_sort(guesses.begin(), guesses.end(),
                   [](const PlacementGuess& a, const PlacementGuess& b) { return a.most_m > b.most_m; });
  return guesses;
}

Mat3 covariance_of(const Mat3& information) {
  return (information + kHold * Mat3::Identity()).inverse();
}

}  // namespace

void MapAlignmentParams::describe(FieldList& fields) {
  fields.real("common_min_m", common_min_m, {1, 1000}, "walls that both maps must have");
  fields.real("fixing_min_m", fixing_min_m, {0.5, 100}, "of these, across every direction");
  fields.real("agreement_min", agreement_min, {0.1, 1},
              "share of the walls in sight of both maps that both must have");
  fields.real("denied_run_max_m", denied_run_max_m, {0.1, 1000},
              "a longer piece of wall that one map has and the other denies contradicts a placement");
  fields.flag("allows_changes", allows_changes,
              "a contradicted placement may be the true one: something was built");
  fields.real("contradicted_share", contradicted_share, {0.1, 1},
              "share at which a contradicted placement makes the best one ambiguous");
  fields.real("rival_share", rival_share, {0.1, 1},
              "a placement that explains this share of what the best one does makes it ambiguous");
  fields.real("rival_agreement", rival_agreement, {0.1, 1}, "if the maps agree so far at it");
  fields.real("apart_m", apart_m, {0.1, 10}, "placements nearer than this are one");
  fields.angle("apart_deg", apart_rad, {1, 90}, "and turned by less than this");
  fields.count("guesses_max", guesses_max, {100, 10000000},
               "placements that are looked at; with more, none is believed");
}

double MapPlacement::sigma_m() const {
  const Mat2 covariance = covariance_of(information).topLeftCorner<2, 2>();
  return std::sqrt(Eigen::SelfAdjointEigenSolver<Mat2>(covariance).eigenvalues().maxCoeff());
}

double MapPlacement::sigma_rad() const {
  return std::sqrt(covariance_of(information)(2, 2));
}

std::string reason_of(const MapAlignment& alignment) {
  switch (alignment.verdict) {
    case AlignmentVerdict::kFound:
      return fmt::format("{:.0f} m of walls are in both, the next best placement explains {:.0f} % as much",
                         alignment.best().overlap.common_m, 100 * alignment.rival_share);
    case AlignmentVerdict::kAmbiguous:
      return fmt::format(
          "parts of the building look alike: one placement has {:.0f} m of walls in common, another explains "
          "{:.0f} % as much",
          alignment.best().overlap.common_m, 100 * alignment.rival_share);
    case AlignmentVerdict::kApart:
      if (alignment.placements.empty()) return "they have no walls in common";
      return fmt::format(
          "they do not show the same walls: the best placement has {:.0f} m in common, which fix it by "
          "{:.0f} m, and {:.0f} m that one has and the other denies, {:.1f} m of it in one piece",
          alignment.best().overlap.common_m, alignment.best().overlap.fixing_m(),
          alignment.best().overlap.denied_m, alignment.best().overlap.denied_run_m);
    case AlignmentVerdict::kUnsearched:
      break;
  }
  return "there are too many placements to look at all of them";
}

MapPlacement settle_map(const MapPattern& fixed, const MapPattern& moved, const Pose2& T_fixed_guess) {
  MapPlacement placement{.T_fixed_moved = T_fixed_guess};
  Pose2& T = placement.T_fixed_moved;
  for (int i = 0; i < kSteps; ++i) {
    const auto [information, pull] = equations_at(fixed, moved, T, i < kWideSteps ? kWideGate_m : kGate_m);
    placement.information = information;
    const Vec3 step = (information + kHold * Mat3::Identity()).ldlt().solve(pull);
    if (!step.allFinite()) break;
    T = {T.x + step.x(), T.y + step.y(), wrap_angle(T.theta + step.z())};
    if (i >= kWideSteps && step.cwiseAbs().maxCoeff() < kSettledStep) break;
  }
  placement.overlap = overlap_of(fixed, moved, T);
  return placement;
}

MapAlignment align_maps(const MapPattern& fixed, const MapPattern& moved, const MapAlignmentParams& params) {
  const auto guesses = guesses_for(fixed, moved, params.common_min_m * params.rival_share);
  Placements placements(params);
  MapAlignment alignment;
  int looked_at = 0;
  for (const PlacementGuess& guess : guesses) {
    if (guess.most_m < params.rival_share * placements.best_score_m()) break;
    if (++looked_at > params.guesses_max) {
      alignment.verdict = AlignmentVerdict::kUnsearched;
      return alignment;
    }
    const MapPlacement placement = settle_map(fixed, moved, guess.T_fixed_moved);
    if (placement.overlap.score_m() > 0) placements.add(placement);
  }
  alignment.placements = std::move(placements.all());
  if (alignment.placements.empty()) return alignment;
  judge(alignment, params);
  alignment.placements.resize(std::min(alignment.placements.size(), kKept));
  return alignment;
}

}  // namespace aisle
