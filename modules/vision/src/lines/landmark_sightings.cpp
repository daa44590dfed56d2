#include "aisle/vision/lines/landmark_sightings.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/core/square.hpp"
#include "lines/line_contrast.hpp"

namespace aisle {

namespace {

constexpr double kBeyondEnd_rad = 1 * kDegree;  // how far an edge may end short of a line on it
constexpr double kLeaningSlack_px = 1.5;        // of a short line's direction
constexpr double kSameWall = 0.03;              // of the distance, between two edges that meet
constexpr double kCutShare = 0.01;      // of the height: a line cut by the image's border shows no end
constexpr double kCornerSide_m = 0.25;  // shortest edge that makes a corner
constexpr double kCornerSine = 0.5;     // of the angle between the two
constexpr double kCornerGap_m = 0.02;   // between an edge's end and the corner ...
constexpr double kCornerGapPerDistance = 0.04;
constexpr double kSameCorner_m = 0.15;
constexpr double kProudSigmas = 2.5;
constexpr double kFar_m = 7;           // what stands farther away is vague, or may hang on a nearer wall
constexpr double kFadedBeneath = 0.6;  // share of its contrast that a line loses at the floor to end there

CameraMount tilted(CameraMount mount, double by_rad) {
  mount.tilt_rad += by_rad;
  return mount;
}

}  // namespace

void LandmarkSightingParams::describe(FieldList& fields) {
  fields.group("verticals", verticals);
  fields.group("floor_edges", floor_edges);
  fields.group("noise", noise);
  fields.real("relief_m", relief_m, {0, 1}, "by which door frames and posters stand proud of their wall");
  fields.real("edge_m", edge_m, {0, 1}, "by which an edge is not sharp or not vertical");
  fields.real("distance_max_m", distance_max_m, {1, 50}, "farther floor points are not used");
  fields.angle("leaning_max_deg", leaning_max_rad, {0, 45}, "how far a line may lean off the vertical");
  fields.real("board_height_m", board_height_m, {0, 1}, "highest skirting board that lines end on");
  fields.real("floor_point_px", floor_point_px, {0, 100},
              "largest distance from the end of a line to the floor edge it stands on");
  fields.flag("corners", corners, "use the corners of the floor's edges");
  fields.flag("hanging", hanging, "use lines that end above the floor, such as a poster's edges");
}

LandmarkDetector::LandmarkDetector(const LandmarkSightingParams& params, const CameraIntrinsics& intrinsics,
                                   const CameraMount& mount)
    : params_(params),
      camera_(intrinsics),
      mount_(mount),
      R_vehicle_camera_(mount.R_vehicle_camera()),
      floor_(camera_, mount, 0),
      floor_tilted_(camera_, tilted(mount, params.noise.tilt_rad), 0),
      verticals_(params.verticals, camera_),
      floor_edge_detector_(params.floor_edges, intrinsics, mount) {}

const std::vector<LandmarkSighting>& LandmarkDetector::detect(const Image& grey) {
  lines_ = verticals_.detect(grey);
  floor_edges_ = &floor_edge_detector_.detect(grey);
  sightings_.clear();
  for (VerticalLine& line : lines_) {
    if (!is_upright(line)) continue;
    meet_edges(line);
    const auto floor_point = floor_point_of(grey, line);
    if (!floor_point) continue;
    line.has_floor_point = true;
    auto sighting = sighting_at(*floor_point);
    if (!sighting) continue;
    sighting->brighter_right = line.contrast > 0;
    sightings_.push_back(*sighting);
  }
  if (params_.corners) add_corners();
  leave_out_far();
  return sightings_;
}

/// Drops far floor points where nearer ones are seen.
void LandmarkDetector::leave_out_far() {
  const auto is_far = [](const LandmarkSighting& seen) { return seen.p_vehicle.norm() > kFar_m; };
  if (std::all_of(sightings_.begin(), sightings_.end(), is_far)) return;
  std::erase_if(sightings_, is_far);
}

std::optional<LandmarkSighting> LandmarkDetector::sighting_at(const Meeting& floor_point) const {
  const auto point = floor_.uncertain_point(floor_point.pixel_px, params_.noise);
  const auto tilted_point = floor_tilted_.point(floor_point.pixel_px);
  if (!point || !tilted_point || point->mean.norm() > params_.distance_max_m) return std::nullopt;
  const Vec2 sight = (point->mean - mount_.p_vehicle_camera.head<2>()).normalized();
  return LandmarkSighting{.p_vehicle = point->mean,
                          .covariance = point->covariance + square(params_.edge_m) * Mat2::Identity() +
                                        square(floor_point.sigma_m) * sight * sight.transpose(),
                          .by_tilt = *tilted_point - point->mean,
                          .floor_point_px = floor_point.pixel_px};
}

/// Corners of floor edges where no vertical line was seen.
void LandmarkDetector::add_corners() {
  for (std::size_t i = 0; i < floor_edges_->size(); ++i) {
    for (std::size_t j = i + 1; j < floor_edges_->size(); ++j) {
      const auto corner = corner_of((*floor_edges_)[i].on_floor.segment, (*floor_edges_)[j].on_floor.segment);
      if (!corner) continue;
      const bool stands = std::any_of(
          sightings_.begin(), sightings_.end(),
          [&](const LandmarkSighting& seen) { return (seen.p_vehicle - *corner).norm() < kSameCorner_m; });
      const auto pixel_px = camera_.project(mount_.to_camera({corner->x(), corner->y(), 0}));
      if (stands || !pixel_px) continue;
      if (const auto sighting = sighting_at({.p_vehicle = *corner, .pixel_px = *pixel_px}))
        sightings_.push_back(*sighting);
    }
  }
  std::sort(sightings_.begin(), sightings_.end(), [](const LandmarkSighting& a, const LandmarkSighting& b) {
    return a.floor_point_px.x() < b.floor_point_px.x();
  });
}

/// Where two edges cross, if both end there and neither is short or nearly parallel to the other.
std::optional<Vec2> LandmarkDetector::corner_of(const Segment2& a, const Segment2& b) const {
  if (std::min(a.length(), b.length()) < kCornerSide_m) return std::nullopt;
  const Vec2 along = a.end - a.start, across_b = left_normal(b.end - b.start);
  const double turn = across_b.dot(along);
  if (std::abs(turn) < kCornerSine * a.length() * b.length()) return std::nullopt;
  const Vec2 corner = a.start + across_b.dot(b.start - a.start) / turn * along;
  const auto off_m = [&](const Segment2& edge) {
    return std::min((corner - edge.start).norm(), (corner - edge.end).norm());
  };
  if (std::max(off_m(a), off_m(b)) > kCornerGap_m + kCornerGapPerDistance * corner.norm())
    return std::nullopt;
  return corner;
}

/// Whether both its ends are seen at the same azimuth.
bool LandmarkDetector::is_upright(const VerticalLine& line) const {
  const auto top = camera_.ray(line.top_px), bottom = camera_.ray(line.bottom_px);
  if (!top || !bottom) return false;
  const Vec3 plane = (R_vehicle_camera_ * top->direction.cross(bottom->direction)).normalized();
  const double slack_rad = kLeaningSlack_px / (line.bottom_px - line.top_px).norm();
  return std::abs(plane.z()) < std::sin(params_.leaning_max_rad) + slack_rad;
}

/// The direction in which a pixel looks, over the floor.
std::optional<Vec2> LandmarkDetector::azimuth(const Vec2& pixel_px) const {
  const auto ray = camera_.ray(pixel_px);
  if (!ray) return std::nullopt;
  return (R_vehicle_camera_ * ray->direction).head<2>().normalized();
}

/// Where the line's azimuth meets the edges, the nearest first. A distorted image shows the line bowed: only
/// its ends are known to lie on it.
void LandmarkDetector::meet_edges(const VerticalLine& line) {
  meetings_.clear();
  const auto top = azimuth(line.top_px), bottom = azimuth(line.bottom_px);
  if (!top || !bottom) return;
  const Vec2 origin = mount_.p_vehicle_camera.head<2>();
  const Vec2 direction = (*top + *bottom).normalized();
  const Vec2 across = left_normal(direction);
  for (const FloorEdge& edge : *floor_edges_) {
    if (may_hang(edge)) continue;
    const Vec2 start = edge.on_floor.segment.start - origin, end = edge.on_floor.segment.end - origin;
    const double from = across.dot(start), to = across.dot(end);
    const double slack = std::sin(kBeyondEnd_rad);
    if (!(from < slack * start.norm() && to > -slack * end.norm() && from < to)) continue;
    const Vec2 point = start + from / (from - to) * (end - start);
    const double distance_m = direction.dot(point);
    const double grazing = std::abs(across.dot(end - start)) / (end - start).norm();
    const auto pixel_px =
        camera_.project(mount_.to_camera({point.x() + origin.x(), point.y() + origin.y(), 0}));
    if (distance_m > 0 && pixel_px)
      meetings_.push_back({point + origin, distance_m, *pixel_px, params_.relief_m / grazing});
  }
  std::sort(meetings_.begin(), meetings_.end(),
            [](const Meeting& a, const Meeting& b) { return a.distance_m < b.distance_m; });
}

/// Whether an edge may be a poster's: the lower edge of a poster on a wall whose floor edge is not seen looks
/// like a floor edge far away, but vertical lines end at both its ends.
bool LandmarkDetector::may_hang(const FloorEdge& edge) const {
  const auto is_end_of_a_line = [&](const Vec2& p_vehicle) {
    const auto pixel_px = camera_.project(mount_.to_camera({p_vehicle.x(), p_vehicle.y(), 0}));
    return pixel_px && std::any_of(lines_.begin(), lines_.end(), [&](const VerticalLine& line) {
             return (line.bottom_px - *pixel_px).norm() < 2 * params_.floor_point_px;
           });
  };
  const Segment2& segment = edge.on_floor.segment;
  return std::min(segment.start.norm(), segment.end.norm()) > kFar_m && is_end_of_a_line(segment.start) &&
         is_end_of_a_line(segment.end);
}

std::optional<LandmarkDetector::Meeting> LandmarkDetector::floor_point_of(const Image& grey,
                                                                          const VerticalLine& line) const {
  if (line.bottom_px.y() > (1 - kCutShare) * grey.height_px) return std::nullopt;
  if (auto standing = standing_floor_point(grey, line)) return standing;
  return hanging_floor_point(line);
}

/// The line ends on an edge or its skirting board, or fades where it meets the edge.
std::optional<LandmarkDetector::Meeting> LandmarkDetector::standing_floor_point(
    const Image& grey, const VerticalLine& line) const {
  for (const Meeting& meeting : meetings_) {
    const double beneath_px = line.bottom_px.y() - meeting.pixel_px.y();
    if (line.top_px.y() > meeting.pixel_px.y() - params_.floor_point_px) continue;
    if (beneath_px < -params_.floor_point_px) {
      if (height_m(line.bottom_px, meeting.distance_m) < params_.board_height_m) return meeting;
      continue;
    }
    if (beneath_px < params_.floor_point_px || stands_proud(line, meeting)) return meeting;
    const double above =
        contrast_between(grey, line, line.top_px.y(), meeting.pixel_px.y() - params_.floor_point_px);
    const double beneath =
        contrast_between(grey, line, meeting.pixel_px.y() + params_.floor_point_px, line.bottom_px.y());
    if (beneath < kFadedBeneath * above) return meeting;
  }
  return std::nullopt;
}

/// The line ends on the floor before the edge, but no farther than what is mounted on the wall.
bool LandmarkDetector::stands_proud(const VerticalLine& line, const Meeting& meeting) const {
  const auto end = floor_.point(line.bottom_px);
  if (!end) return false;
  const double distance_m = (*end - mount_.p_vehicle_camera.head<2>()).norm();
  return meeting.distance_m - distance_m < kProudSigmas * meeting.sigma_m;
}

/// The line ends above the one edge in its direction.
std::optional<LandmarkDetector::Meeting> LandmarkDetector::hanging_floor_point(
    const VerticalLine& line) const {
  if (!params_.hanging || meetings_.empty()) return std::nullopt;
  const Meeting& nearest = meetings_.front();
  if (meetings_.back().distance_m > (1 + kSameWall) * nearest.distance_m) return std::nullopt;
  if (height_m(line.bottom_px, nearest.distance_m) < params_.board_height_m) return std::nullopt;
  return nearest;
}

/// Above the floor, of what is seen at a distance from the point beneath the lens.
double LandmarkDetector::height_m(const Vec2& pixel_px, double distance_m) const {
  const auto ray = camera_.ray(pixel_px);
  if (!ray) return 0;
  const Vec3 direction = R_vehicle_camera_ * ray->direction;
  return mount_.p_vehicle_camera.z() + distance_m * direction.z() / direction.head<2>().norm();
}

}  // namespace aisle
