#include "aisle/localisation/view_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "aisle/core/cauchy.hpp"
#include "aisle/core/square.hpp"

namespace aisle {
namespace {

constexpr double kOnSurface_m = 0.04;
constexpr double kBeside_m = 0.08;  // a beam this far beside another may pass the edge that it meets
constexpr double kLeastStep_m = 0.03;
constexpr int kIterations = 12;
constexpr double kGate_m = 0.35;
constexpr double kHitSigma_m = 0.03;
constexpr double kCellSigma_m = 0.06;  // of furniture, which is known by its cells
constexpr double kCauchy_m = 0.05;
constexpr double kSharedError = 6;  // neighbouring hits have common errors: so many count as one
constexpr double kNear_m = 0.15;
constexpr double kSettled = 1e-4;

enum class BeamFate { kExplained, kShort, kUnknown, kThrough };

/// Follows a line from surface to surface. What can be carried away may be gone: nothing goes through it.
bool crosses_surface(const SurfaceField& field, const Vec2& p_from, const Vec2& p_to, double beyond_m) {
  const Vec2 along = p_to - p_from;
  const double length_m = along.norm();
  bool has_crossed = false;
  for (double s = kLeastStep_m; s < length_m;) {
    const Vec2 p = p_from + along * (s / length_m);
    const double free_m = field.distance_m(p);
    if (has_crossed && free_m > beyond_m) return true;
    has_crossed |= free_m < kOnSurface_m && field.nearest(p)->is_fixed;
    s += std::max(kLeastStep_m, has_crossed ? 0.0 : free_m - kOnSurface_m);
  }
  return false;
}

/// Past an edge, a jamb or a leg, what a beam meets depends on a few centimetres: it goes through a surface
/// only if the beams to its left and right do, too.
bool goes_through(const SurfaceField& field, const Vec2& p_from, const Vec2& p_to, double beyond_m) {
  if (!crosses_surface(field, p_from, p_to, beyond_m)) return false;
  const Vec2 along = (p_to - p_from).normalized();
  const Vec2 aside = kBeside_m * Vec2(-along.y(), along.x());
  return crosses_surface(field, p_from + aside, p_to + aside, beyond_m) &&
         crosses_surface(field, p_from - aside, p_to - aside, beyond_m);
}

BeamFate fate_of(const SurfaceField& field, const ViewBeam& beam, const Pose2& T_map_vehicle,
                 const ViewFitParams& params) {
  const Vec2 p_hit = T_map_vehicle * beam.p_hit, p_laser = T_map_vehicle * beam.p_laser;
  if (goes_through(field, p_laser, p_hit, params.beyond_m)) return BeamFate::kThrough;
  if (field.distance_m(p_hit) <= params.near_m) return BeamFate::kExplained;
  return field.can_stand(p_hit) ? BeamFate::kShort : BeamFate::kUnknown;
}

/// Of a hit that is explained: how far it is from being not, 0 to 1.
double share_off(const SurfaceField& field, const Vec2& p_map_hit, const ViewFitParams& params) {
  const double off_m = field.nearest(p_map_hit)->segment.distance(p_map_hit);
  if (off_m <= params.on_m) return 0;
  return std::clamp((off_m - params.on_m) / (params.near_m - params.on_m), 0.0, 1.0);
}

struct Residual {
  double off_m = 0;
  Vec2 normal = Vec2::Zero();
  double weight = 0;
};

/// How a hit lies to the surface that is nearest to it.
Residual residual_of(const SurfaceField& field, const Vec2& p_map_hit, const Vec2& p_map_laser) {
  const Surface* const surface = field.nearest(p_map_hit);
  if (surface == nullptr) return {};
  const double distance_m = surface->segment.distance(p_map_hit);
  if (distance_m > kGate_m) return {};
  Residual residual;
  double sigma_m = kHitSigma_m;
  if (surface->is_wall()) {
    if (surface->normal.dot(p_map_laser - p_map_hit) < 0) return {};
    residual.normal = surface->normal;
    residual.off_m = surface->normal.dot(p_map_hit - surface->segment.start);
  } else {
    sigma_m = kCellSigma_m;
    if (distance_m < 1e-6) return {};
    residual.off_m = distance_m;
    residual.normal = (p_map_hit - surface->segment.start) / distance_m;
  }
  residual.weight = cauchy_weight(residual.off_m, kCauchy_m) / (square(sigma_m) * kSharedError);
  return residual;
}

}  // namespace

void ViewFitParams::describe(FieldList& fields) {
  fields.real("on_m", on_m, {0, 0.5}, "a hit this near to a surface is on it");
  fields.real("near_m", near_m, {0.02, 1}, "a hit this near to a surface is explained by it");
  fields.real("beyond_m", beyond_m, {0.05, 2},
              "a beam this far off a surface that it crossed went through it");
  fields.real("through_weight", through_weight, {1, 10},
              "how much more a beam counts that goes through walls");
}

ViewFit fit_of(const SurfaceField& field, std::span<const ViewBeam> beams, double piece_m,
               const Pose2& T_map_vehicle, const ViewFitParams& params) {
  ViewFit fit{.beams = static_cast<int>(beams.size())};
  for (const ViewBeam& beam : beams) {
    const BeamFate fate = fate_of(field, beam, T_map_vehicle, params);
    fit.explained += fate == BeamFate::kExplained ? 1 : 0;
    fit.unknown += fate == BeamFate::kUnknown ? 1 : 0;
    fit.through += fate == BeamFate::kThrough ? 1 : 0;
    const double cost = fate == BeamFate::kThrough     ? params.through_weight
                        : fate == BeamFate::kExplained ? share_off(field, T_map_vehicle * beam.p_hit, params)
                                                       : 1;
    fit.misfit_m += piece_m * cost;
    fit.chance_m += piece_m * square(cost);
  }
  return fit;
}

SurfaceAlignment align_to_surfaces(const SurfaceField& field, std::span<const Vec2> hits, const Vec2& p_laser,
                                   const Pose2& guess, const Mat3& guess_information) {
  SurfaceAlignment result{guess};
  Pose2& T = result.T_map_vehicle;
  for (int i = 0; i < kIterations; ++i) {
    Mat3 information = Mat3::Zero();
    Vec3 pull = Vec3::Zero();
    int near = 0;
    const Mat2 turn = rotation(T.theta);
    const Vec2 p_map_laser = T * p_laser;
    for (const Vec2& hit : hits) {
      const Vec2 turned = turn * hit;
      const Residual residual = residual_of(field, T.position() + turned, p_map_laser);
      if (residual.weight <= 0) continue;
      near += std::abs(residual.off_m) < kNear_m ? 1 : 0;
      const Vec3 slope(residual.normal.x(), residual.normal.y(), residual.normal.dot(left_normal(turned)));
      information += residual.weight * slope * slope.transpose();
      pull -= residual.weight * residual.off_m * slope;
    }
    result.information = information;
    result.near_share = hits.empty() ? 0 : static_cast<double>(near) / static_cast<double>(hits.size());
    const Vec3 off_guess(guess.x - T.x, guess.y - T.y, wrap_angle(guess.theta - T.theta));
    const Mat3 damped = information + guess_information + 1e-3 * Mat3::Identity();
    const Vec3 step = damped.ldlt().solve(Vec3(pull + guess_information * off_guess));
    if (!step.allFinite()) break;
    T = {T.x + step.x(), T.y + step.y(), wrap_angle(T.theta + step.z())};
    if (step.cwiseAbs().maxCoeff() < kSettled) break;
  }
  return result;
}

}  // namespace aisle
