#include "aisle/guidance/sections/section_localiser.hpp"

#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/core/cauchy.hpp"
#include "aisle/learning/walls/wall_heading.hpp"

namespace aisle {
namespace {

constexpr double kEndDirection_rad = 0.4 * kDegree;  // bearing error of the end of a base line
constexpr double kEndSigmaMax_m = 0.08;              // an end that is less certain is not used
constexpr double kUsual_m = 0.05;                    // usual error of a base line; doors are farther off

}  // namespace

void SectionLocaliserParams::describe(FieldList& fields) {
  fields.real("start_sigma_m", start_sigma_m, {0.001, 2}, "uncertainty of the start position");
  fields.angle("start_sigma_deg", start_sigma_rad, {0.1, 45}, "uncertainty of the start heading");
  fields.real("wall_sigma_m", wall_sigma_m, {0.001, 1}, "standard deviation of a base line's distance");
  fields.real("wall_gate_m", wall_gate_m, {0.01, 2},
              "a base line farther than this from its expected place is another");
  fields.real("length_gate_m", length_gate_m, {0.01, 5},
              "the same for a wall ahead and the end of a base line");
  fields.real("length_reach_m", length_reach_m, {0.2, 20}, "a wall ahead that is farther away is not used");
  fields.real("repeat_inflation", repeat_inflation, {1, 100},
              "factor on the variances, as images in a row are not independent");
  fields.flag("heading_by_walls", heading_by_walls, "floor edges at right angles correct the heading");
  fields.flag("left_base_line", left_base_line, "the left base line is followed as well as the right one");
  fields.flag("length_by_wall_ahead", length_by_wall_ahead, "the wall ahead corrects a section's length");
  fields.flag("length_by_line_end", length_by_line_end,
              "the end of the base line before a turn corrects a section's length");
}

/// The wheels keep their size, so the odometry's scale error is the same on the path out and home.
SectionLocaliser::SectionLocaliser(const SectionLocaliserParams& params, const VehicleDescription& vehicle,
                                   const GuidedPath& guided)
    : params_(params),
      guided_(&guided),
      filter_(vehicle, about(guided.path.at(0).T_map_path, params.start_sigma_m, params.start_sigma_rad),
              {0, PoseFilter::kForgotten_per_m, PoseFilter::kForgotten_per_m}) {}

void SectionLocaliser::correct(std::span<const SensedSegment> edges, std::size_t piece) {
  is_guided_ = false;
  if (params_.heading_by_walls) correct_heading(edges);
  if (guided_->path.pieces()[piece].is_on_the_spot()) return;
  find_walls_beside(edges, here(piece).T_piece_vehicle, beside_);
  if (guided_->guides[piece].follows) correct_distance(here(piece));
  if (params_.length_by_wall_ahead) correct_by_wall_ahead(here(piece), edges);
  if (params_.length_by_line_end) correct_by_line_end(here(piece));
}

SectionLocaliser::Here SectionLocaliser::here(std::size_t piece) const {
  const PathPiece& present = guided_->path.pieces()[piece];
  return {present, guided_->guides[piece], between(present.T_map_start, filter_.pose())};
}

/// Assumes that every edge is parallel to an axis of the map.
void SectionLocaliser::correct_heading(std::span<const SensedSegment> edges) {
  for (const SensedSegment& edge : edges) {
    const auto misfit = misfit_to_axis(edge, filter_.pose().theta);
    if (!misfit) continue;
    const double usual_rad = std::hypot(misfit->usual_rad, std::sqrt(heading_variance()));
    const double weight = cauchy_weight(misfit->off_rad, usual_rad);
    filter_.correct(-misfit->off_rad, Vec3::UnitZ(), inflated(misfit->sigma_rad / weight));
  }
}

/// L03 section 4.1. A pitch error of the camera makes both base lines look too near, or both too far. It
/// cancels out where both are used.
void SectionLocaliser::correct_distance(const Here& here) {
  double off_m = 0, ahead_m = 0, weights = 0, nod_m = 0;
  const auto add = [&](double lateral_m) {
    const WallBeside* wall = wall_at(lateral_m);
    if (wall == nullptr || wall->from_m > here.piece.path_m()) return;
    const double weight = 1 / wall->sigma_m;
    off_m += weight * (lateral_m - wall->lateral_m);
    ahead_m += weight * rotate(here.T_piece_vehicle.theta, wall->p_vehicle).x();
    weights += weight;
    nod_m += lateral_m < 0 ? -1 : 1;
  };
  if (here.guide.right_m) add(-*here.guide.right_m);
  if (here.guide.left_m && params_.left_base_line) add(*here.guide.left_m);
  if (weights == 0) return;
  off_m /= weights;
  const Vec2 left = left_normal(unit(here.piece.T_map_start.theta));
  const Vec3 by_pose{left.x(), left.y(), ahead_m / weights};
  const double sigma_m = std::hypot(nod_m / weights, params_.wall_sigma_m) * distrust(off_m, by_pose);
  is_guided_ = filter_.correct(off_m, by_pose, inflated(sigma_m));
}

/// The base line nearest to the expected place; nullptr if none is near.
const WallBeside* SectionLocaliser::wall_at(double lateral_m) const {
  const WallBeside* nearest = nullptr;
  double least_m = params_.wall_gate_m;
  for (const WallBeside& wall : beside_) {
    const double off_m = std::abs(wall.lateral_m - lateral_m);
    if (off_m >= least_m) continue;
    least_m = off_m;
    nearest = &wall;
  }
  return nearest;
}

void SectionLocaliser::correct_by_wall_ahead(const Here& here, std::span<const SensedSegment> edges) {
  if (!here.guide.ahead_m) return;
  const double expected_m = here.piece.path_m() + *here.guide.ahead_m;
  find_walls_across(edges, here.T_piece_vehicle, across_);
  const WallAcross* nearest = nullptr;
  double least_m = params_.length_gate_m;
  for (const WallAcross& wall : across_) {
    const double off_m = std::abs(wall.along_m - expected_m);
    if (wall.along_m - here.T_piece_vehicle.x > params_.length_reach_m || off_m >= least_m) continue;
    least_m = off_m;
    nearest = &wall;
  }
  if (nearest == nullptr) return;
  const double off_m = expected_m - nearest->along_m;
  const Vec2 along = unit(here.piece.T_map_start.theta);
  const Vec3 by_pose{along.x(), along.y(), 0};
  const double sigma_m = std::hypot(nearest->sigma_m, params_.wall_sigma_m) * distrust(off_m, by_pose);
  filter_.correct(off_m, by_pose, inflated(sigma_m));
}

/// L03 section 4.3: the point where the base line ends tells the distance to the turn.
void SectionLocaliser::correct_by_line_end(const Here& here) {
  const auto lateral_m = here.guide.turns_right ? here.guide.right_m : here.guide.left_m;
  if (!here.guide.line_ends_m || !lateral_m) return;
  const double side = here.guide.turns_right ? -1 : 1;
  const double expected_m = here.piece.path_m() - *here.guide.line_ends_m;
  for (const WallBeside& wall : beside_) {
    const double off_m = expected_m - wall.to_m;
    if (std::abs(off_m) > params_.length_gate_m ||
        std::abs(wall.lateral_m - side * *lateral_m) > params_.wall_gate_m)
      continue;
    const Vec2 p_vehicle = here.T_piece_vehicle.inverse() * Vec2(wall.to_m, wall.lateral_m);
    const double sigma_m = kEndDirection_rad * p_vehicle.squaredNorm() / std::abs(wall.lateral_m);
    if (sigma_m > kEndSigmaMax_m) continue;
    const Vec2 along = unit(here.piece.T_map_start.theta);
    const double left_m = rotate(here.T_piece_vehicle.theta, p_vehicle).y();
    filter_.correct(off_m, {along.x(), along.y(), -left_m},
                    inflated(std::hypot(sigma_m, params_.wall_sigma_m)));
    return;
  }
}

double SectionLocaliser::lateral_sigma_m(double heading_rad) const {
  const Vec2 left = left_normal(unit(heading_rad));
  return sigma_of({left.x(), left.y(), 0});
}

double SectionLocaliser::sigma_of(const Vec3& by_pose) const {
  return std::sqrt(by_pose.dot(filter_.covariance().topLeftCorner<3, 3>() * by_pose));
}

/// A measurement that is off by no more than the pose's uncertainty is not distrusted.
double SectionLocaliser::distrust(double off_m, const Vec3& by_pose) const {
  return cauchy_distrust(off_m, std::hypot(kUsual_m, sigma_of(by_pose)));
}

double SectionLocaliser::inflated(double sigma) const {
  return sigma * std::sqrt(params_.repeat_inflation);
}

}  // namespace aisle
