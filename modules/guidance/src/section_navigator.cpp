#include "aisle/guidance/section_navigator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "aisle/core/square.hpp"
#include "aisle/learning/wall_heading.hpp"

namespace aisle {
namespace {

const CameraDescription& named_camera(const VehicleDescription& vehicle, const std::string& name) {
  if (const CameraDescription* camera = vehicle.camera(name)) return *camera;
  throw std::invalid_argument("the vehicle lacks the camera that is to look along the corridor");
}

void append(GuidedPath& way, std::vector<PathPiece>& pieces, const PathPiece& piece,
            const SectionGuide& guide) {
  pieces.push_back(piece);
  way.guides.push_back(guide);
}

}  // namespace

GuidedPath guided_path(const SectionList& sections, const Pose2& T_map_start, SectionTrip trip) {
  std::vector<std::size_t> piece_sections;
  const Path there = path_of(sections, T_map_start, &piece_sections);
  const auto guide_of = [&](std::size_t piece) {
    const Section& section = sections[piece_sections[piece]];
    const bool follows = section.kind == Section::Kind::kFollow || section.kind == Section::Kind::kHybrid;
    return SectionGuide{piece_sections[piece], follows, section.right_m, section.left_m};
  };
  GuidedPath way;
  std::vector<PathPiece> pieces;
  if (trip != SectionTrip::kBack) {
    for (std::size_t i = 0; i < piece_sections.size(); ++i)
      append(way, pieces, there.pieces()[i], guide_of(i));
  }
  if (trip == SectionTrip::kThereAndBack)
    append(way, pieces, {there.pieces().back().end(), {0, kPi}}, {.section = sections.size() - 1});
  if (trip != SectionTrip::kThere) {
    const Path back = there.reversed();
    for (std::size_t i = 0; i < back.pieces().size(); ++i) {
      SectionGuide guide = guide_of(back.pieces().size() - 1 - i);
      std::swap(guide.right_m, guide.left_m);
      append(way, pieces, back.pieces()[i], guide);
    }
  }
  way.path = Path(std::move(pieces));
  return way;
}

void SectionNavigatorParams::describe(FieldList& fields) {
  fields.group("floor_edges", floor_edges);
  fields.group("steering", steering);
  fields.group("speed", speed);
  fields.real("look_s", look_s, {0, 60}, "time to look where it stands before it starts");
  fields.real("start_sigma_m", start_sigma_m, {0.001, 2},
              "how far from the way's start the vehicle may stand");
  fields.angle("start_sigma_deg", start_sigma_rad, {0.1, 45}, "how far it may be turned there");
  fields.real("wall_sigma_m", wall_sigma_m, {0.001, 1}, "how steadily a base line keeps its distance");
  fields.real("wall_gate_m", wall_gate_m, {0.01, 2},
              "a base line farther from where it should be is another");
  fields.real("repeat_inflation", repeat_inflation, {1, 100},
              "pictures in a row are not independent: their variances count so many times");
  fields.real("lost_m", lost_m, {0.01, 10}, "less sure how far aside of its way it is, it gives up");
  fields.flag("heading_by_walls", heading_by_walls, "floor edges at right angles correct the heading");
  fields.flag("left_base_line", left_base_line, "is followed where the right one is not seen");
}

SectionNavigator::SectionNavigator(const SectionNavigatorParams& params, const VehicleDescription& vehicle,
                                   const std::string& camera, SectionList sections, GuidedPath way)
    : params_(params),
      vehicle_(vehicle),
      camera_(camera),
      sections_(std::move(sections)),
      way_(std::move(way)),
      detector_(params.floor_edges, named_camera(vehicle, camera).intrinsics,
                named_camera(vehicle, camera).mount),
      filter_(vehicle, about(way_.path.at(0).T_map_path, params.start_sigma_m, params.start_sigma_rad)),
      follower_(vehicle, params.steering),
      progress_(way_.path) {}

Decision SectionNavigator::step(const Observation& observation) {
  if (!begun_s_) begun_s_ = observation.stamp_s;
  locate(observation);
  if (observation.bumper_pressed) return fail("bumped", "the bumper is pressed");
  if (observation.stamp_s - *begun_s_ < params_.look_s) return {.state = "looking"};
  const PathPoint& point = progress_.advance(filter_.pose());
  if (progress_.has_arrived()) return {.status = NavigatorStatus::kDone, .state = "arrived"};
  if (aside_sigma_m() > params_.lost_m)
    return fail("lost", fmt::format("saw no base line until unsure by {:.2f} m", aside_sigma_m()));
  const double speed_mps = speed_along(way_.path, point.along_m, 1, vehicle_, params_.speed);
  return {.command = follower_.follow(way_.path, point, filter_.pose(), speed_mps, 0),
          .state = is_guided_ ? "following" : "reckoning",
          .why = place()};
}

/// Odometry, then the picture.
void SectionNavigator::locate(const Observation& observation) {
  filter_.predict(observation.odometry);
  is_guided_ = false;
  const CameraPicture* picture = present_picture(observation, camera_, vehicle_.cycle_s);
  if (picture == nullptr) return;
  edges_.clear();
  for (const FloorEdge& edge : detector_.detect(*picture->image)) edges_.push_back(edge.on_floor);
  if (params_.heading_by_walls) correct_heading();
  if (guide().follows) correct_distance();
}

/// The map's axes are the walls'.
void SectionNavigator::correct_heading() {
  const double heading_rad = filter_.pose().theta;
  const auto walls = heading_from_walls(edges_, heading_rad, std::sqrt(filter_.covariance()(2, 2)));
  if (!walls) return;
  filter_.correct(wrap_angle(walls->heading_rad - heading_rad), Vec3::UnitZ(),
                  walls->sigma_rad * std::sqrt(params_.repeat_inflation));
}

/// L03 section 4.1, as a correction of the pose: the vehicle steers by its path alone.
void SectionNavigator::correct_distance() {
  const PathPiece& piece = way_.path.pieces()[progress_.point().piece];
  const Pose2 T_piece_vehicle = between(piece.T_map_start, filter_.pose());
  find_walls_beside(edges_, T_piece_vehicle, beside_);
  std::erase_if(beside_, [&](const WallBeside& wall) { return wall.from_m > piece.way_m(); });
  std::optional<double> aside_m;
  const WallBeside* wall = nullptr;
  if (guide().right_m) wall = wall_at(*(aside_m = -*guide().right_m));
  if (wall == nullptr && guide().left_m && params_.left_base_line)
    wall = wall_at(*(aside_m = *guide().left_m));
  if (wall == nullptr) return;
  const Vec2 left = left_normal(unit(piece.T_map_start.theta));
  const double ahead_m = rotate(T_piece_vehicle.theta, wall->p_vehicle).x();
  const double variance = square(wall->sigma_m) + square(params_.wall_sigma_m);
  is_guided_ = filter_.correct(*aside_m - wall->aside_m, {left.x(), left.y(), ahead_m},
                               std::sqrt(params_.repeat_inflation * variance));
}

/// The base line nearest to where one should be; nullptr: none is near.
const WallBeside* SectionNavigator::wall_at(double aside_m) const {
  const WallBeside* nearest = nullptr;
  double least_m = params_.wall_gate_m;
  for (const WallBeside& wall : beside_) {
    const double off_m = std::abs(wall.aside_m - aside_m);
    if (off_m >= least_m) continue;
    least_m = off_m;
    nearest = &wall;
  }
  return nearest;
}

double SectionNavigator::aside_sigma_m() const {
  const Vec2 left = left_normal(unit(progress_.point().T_map_path.theta));
  return std::sqrt(left.dot(filter_.covariance().topLeftCorner<2, 2>() * left));
}

std::string SectionNavigator::place() const {
  return fmt::format("section {} of {}", guide().section + 1, sections_.size());
}

Decision SectionNavigator::fail(std::string state, const std::string& what) const {
  return {.status = NavigatorStatus::kFailed, .state = std::move(state), .why = what + " in " + place()};
}

}  // namespace aisle
