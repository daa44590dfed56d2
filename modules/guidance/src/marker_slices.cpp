#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "aisle/geometry/back_projection.hpp"
#include "aisle/guidance/slice_sensor.hpp"
#include "aisle/vision/laser_stripes.hpp"

namespace aisle {
namespace {

constexpr double kFanStep_rad = 0.25 * kDegree;
constexpr double kStripeReach_m = 12;  // a stripe farther away is too uncertain to tell free floor before it
constexpr double kPictureEdge_px = 8;  // lenses and stripes are poor there
constexpr double kNearStep_m = 0.05;
constexpr double kLinked_px = 3;  // points of a stripe so near to each other belong together

const CameraDescription& marker_camera(const VehicleDescription& vehicle, const std::string& name) {
  if (!vehicle.laser_markers) throw std::invalid_argument("the vehicle has no laser markers");
  const CameraDescription* camera = vehicle.camera(name);
  if (camera == nullptr) throw std::invalid_argument("the vehicle has no camera " + name);
  return *camera;
}

/// C99 section 3.1: stripes in the picture, back-projected at the height of the light plane, as a fan about
/// the point below the lens.
class MarkerSlices final : public SliceSensor {
 public:
  MarkerSlices(const VehicleDescription& vehicle, const CameraDescription& camera)
      : camera_(camera),
        cycle_s_(vehicle.cycle_s),
        height_m_(vehicle.laser_markers->height_m),
        plane_(CameraModel(camera.intrinsics), camera.mount, height_m_) {
    lay_fan();
    find_near();
  }

  const LaserScanner& fan() const override { return fan_; }

  bool look(const Observation& observation, SliceView& view) override {
    const CameraPicture* picture = present_picture(observation, camera_.name, cycle_s_);
    if (picture == nullptr) return false;
    view.ranges_m.assign(near_m_.size(), 0);
    view.near_m = near_m_;
    for (const LaserStripe& stripe : find_laser_stripes(*picture->image)) put(stripe, view.ranges_m);
    return true;
  }

 private:
  /// As wide as the picture's middle row sees.
  void lay_fan() {
    const auto edge_rad = [&](double column_px) {
      const Vec2 pixel(column_px, 0.75 * camera_.height_px);
      const auto p_vehicle = plane_.point(pixel);
      return p_vehicle ? heading_of(*p_vehicle - p_vehicle_lens()) : 0;
    };
    const double left_rad = edge_rad(kPictureEdge_px);
    const double right_rad = edge_rad(camera_.width_px - 1 - kPictureEdge_px);
    fan_.first_angle_rad = right_rad;
    fan_.angle_step_rad = kFanStep_rad;
    fan_.range_max_m = kStripeReach_m;
    fan_.T_vehicle_laser = {p_vehicle_lens().x(), p_vehicle_lens().y(), 0};
    near_m_.resize(static_cast<std::size_t>((left_rad - right_rad) / kFanStep_rad) + 1);
  }

  /// How near to the lens each beam comes into the picture.
  void find_near() {
    const CameraModel model(camera_.intrinsics);
    for (std::size_t beam = 0; beam < near_m_.size(); ++beam) {
      const Vec2 along = unit(fan_.beam_angle(beam));
      int step = 1;
      for (; step * kNearStep_m < kStripeReach_m; ++step) {
        const Vec2 p = p_vehicle_lens() + step * kNearStep_m * along;
        const auto pixel = model.project(camera_.mount.to_camera({p.x(), p.y(), height_m_}));
        if (pixel && is_inside(*pixel)) break;
      }
      near_m_[beam] = static_cast<float>(step * kNearStep_m);
    }
  }

  bool is_inside(const Vec2& pixel) const {
    return pixel.x() >= kPictureEdge_px && pixel.y() >= kPictureEdge_px &&
           pixel.x() <= camera_.width_px - 1 - kPictureEdge_px &&
           pixel.y() <= camera_.height_px - 1 - kPictureEdge_px;
  }

  Vec2 p_vehicle_lens() const { return camera_.mount.p_vehicle_camera.head<2>(); }

  /// Every beam between two points of a stripe that belong together strikes the line between them.
  void put(const LaserStripe& stripe, std::vector<float>& ranges_m) const {
    bool is_linked = false;
    Vec2 pixel_before = Vec2::Zero(), p_before = Vec2::Zero();
    for (const Vec2& pixel : stripe.points_px) {
      const auto p_vehicle = plane_.point(pixel);
      if (p_vehicle) {
        const Vec2 p = *p_vehicle - p_vehicle_lens();
        if (is_linked && (pixel - pixel_before).norm() < kLinked_px) put_line(p, p_before, ranges_m);
        pixel_before = pixel;
        p_before = p;
      }
      is_linked = p_vehicle.has_value();
    }
  }

  void put_line(const Vec2& right, const Vec2& left, std::vector<float>& ranges_m) const {
    const double first = (heading_of(right) - fan_.first_angle_rad) / kFanStep_rad;
    const double last = (heading_of(left) - fan_.first_angle_rad) / kFanStep_rad;
    const auto beams = static_cast<int>(ranges_m.size());
    for (int beam = static_cast<int>(std::ceil(std::max(0.0, first))); beam <= last && beam < beams; ++beam) {
      const double share = last > first ? (beam - first) / (last - first) : 0;
      const auto range_m = static_cast<float>((right + share * (left - right)).norm());
      float& held_m = ranges_m[static_cast<std::size_t>(beam)];
      if (held_m == 0 || range_m < held_m) held_m = range_m;
    }
  }

  CameraDescription camera_;
  double cycle_s_;
  double height_m_;
  BackProjection plane_;
  LaserScanner fan_;
  std::vector<float> near_m_;
};

}  // namespace

std::unique_ptr<SliceSensor> marker_slices(const VehicleDescription& vehicle, const std::string& camera) {
  return std::make_unique<MarkerSlices>(vehicle, marker_camera(vehicle, camera));
}

}  // namespace aisle
