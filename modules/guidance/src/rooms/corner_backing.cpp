#include "aisle/guidance/rooms/corner_backing.hpp"

#include "aisle/guidance/rooms/room_cameras.hpp"

namespace aisle {

void CornerBackingParams::describe(FieldList& fields) {
  fields.flag("by_corner", by_corner, "it reverses until the third camera shows the corner; else as taught");
  fields.group("corner", corner);
  fields.angle("steering_deg", steering_rad, {0, 60},
               "steering angle while reversing, away from the next turning");
  fields.real("speed_mps", speed_mps, {0.02, 1}, "while reversing");
  fields.real("least_share", least_share, {0, 1},
              "share of the taught reverse path after which the corner counts");
  fields.real("most_share", most_share, {0.1, 5},
              "share of the taught reverse path after which it turns off without having seen the corner");
  fields.real("agree_m", agree_m, {0.01, 2}, "by which the corner may move from one image to the next");
  fields.count("images", images, {1, 100}, "images in a row that must show the corner");
}

CornerBacking::CornerBacking(const CornerBackingParams& params, const RouteViewParams& view,
                             const VehicleDescription& vehicle)
    : params_(params),
      vehicle_(vehicle),
      camera_(room_camera(vehicle, kThirdCamera)),
      view_(view, camera_.intrinsics, camera_.mount, camera_.width_px, camera_.height_px,
            vehicle.footprint.width_m) {}

void CornerBacking::begin(TurningClass next, double taught_m, const Pose2& T_odom_vehicle) {
  side_ = next == TurningClass::kLeft ? RouteSide::kLeft : RouteSide::kRight;
  taught_m_ = taught_m;
  T_odom_begin_ = T_odom_vehicle;
  p_odom_corner_.reset();
  images_ = 0;
}

void CornerBacking::look(const Observation& observation, const Pose2& T_odom_vehicle) {
  const CameraImage* image = present_image(observation, camera_.name, vehicle_.cycle_s);
  if (image == nullptr || backed_m(T_odom_vehicle) < params_.least_share * taught_m_) return;
  const RouteSight& sight = view_.look(*image->pixels);
  const auto p_vehicle_corner = find_route_corner(
      sight.p_vehicle_edges, camera_.mount.p_vehicle_camera.head<2>(), side_, params_.corner);
  if (!p_vehicle_corner) {
    images_ = 0;
    return;
  }
  const Vec2 p_odom = T_odom_vehicle * *p_vehicle_corner;
  const bool agrees = p_odom_corner_ && (p_odom - *p_odom_corner_).norm() <= params_.agree_m;
  images_ = agrees ? images_ + 1 : 1;
  p_odom_corner_ = p_odom;
}

double CornerBacking::requested_steering_rad() const {
  return side_ == RouteSide::kLeft ? -params_.steering_rad : params_.steering_rad;
}

bool CornerBacking::is_done(const Pose2& T_odom_vehicle) const {
  return has_seen_corner() || backed_m(T_odom_vehicle) >= params_.most_share * taught_m_;
}

double CornerBacking::backed_m(const Pose2& T_odom_vehicle) const {
  return (T_odom_vehicle.position() - T_odom_begin_.position()).norm();
}

}  // namespace aisle
