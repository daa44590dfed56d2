#include <algorithm>
#include <stdexcept>

#include "aisle/guidance/exploration/scan_source.hpp"
#include "aisle/vision/stripes/stripe_scan.hpp"

namespace aisle {
namespace {

constexpr StripeScanParams kStripeParams;

const CameraDescription& marker_camera(const VehicleDescription& vehicle, const std::string& name) {
  if (!vehicle.laser_markers) throw std::invalid_argument("the vehicle has no laser markers");
  const CameraDescription* camera = vehicle.camera(name);
  if (camera == nullptr) throw std::invalid_argument("the vehicle has no camera " + name);
  return *camera;
}

/// C99 section 3.1: the laser stripe in the image as a polar scan about the point below the lens.
class MarkerScans final : public ScanSource {
 public:
  MarkerScans(const VehicleDescription& vehicle, const CameraDescription& camera)
      : camera_(camera),
        cycle_s_(vehicle.cycle_s),
        stripe_(kStripeParams, camera.intrinsics, camera.mount, camera.width_px, camera.height_px,
                vehicle.laser_markers->height_m) {
    const Vec3& p_vehicle_lens = camera.mount.p_vehicle_camera;
    scanner_ = {.first_angle_rad = stripe_.first_angle_rad(),
                .angle_step_rad = StripeScan::angle_step_rad(),
                .range_max_m = kStripeParams.sure_reach_m,
                .T_vehicle_laser = {p_vehicle_lens.x(), p_vehicle_lens.y(), camera.mount.pan_rad}};
    for (const StripeScan::Beam& beam : stripe_.beams()) near_m_.push_back(beam.near_m);
  }

  const LaserScanner& scanner() const override { return scanner_; }

  bool look(const Observation& observation, ScanView& view) override {
    const CameraImage* image = present_image(observation, camera_.name, cycle_s_);
    if (image == nullptr) return false;
    stripe_.find(as_grey(*image->pixels, grey_));
    view.near_m = near_m_;
    view.ranges_m.clear();
    for (const StripeScan::Beam& beam : stripe_.beams()) view.ranges_m.push_back(range_m(beam));
    return true;
  }

 private:
  /// A beam without light is free as far as it lies in the image, provided that light could be seen at all.
  float range_m(const StripeScan::Beam& beam) const {
    if (!stripe_.sees_light() || beam.may_be_shut) return 0;
    if (beam.range_m > 0) return std::min(beam.range_m, static_cast<float>(kStripeParams.sure_reach_m));
    return beam.far_m >= kStripeParams.sure_reach_m ? static_cast<float>(kStripeParams.sure_reach_m) : 0;
  }

  CameraDescription camera_;
  double cycle_s_;
  StripeScan stripe_;
  LaserScanner scanner_;
  std::vector<float> near_m_;
  Image grey_;  ///< of coloured images
};

}  // namespace

std::unique_ptr<ScanSource> marker_scans(const VehicleDescription& vehicle, const std::string& camera) {
  return std::make_unique<MarkerScans>(vehicle, marker_camera(vehicle, camera));
}

}  // namespace aisle
