#include "aisle/guidance/image_monitor.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "aisle/vehicle/odometry_step.hpp"

namespace aisle {
namespace {

// So much motion shows in an image; what odometry reports of a vehicle that stands is less.
constexpr double kShownMotion_m = 0.02;
constexpr double kShownTurn_rad = 0.01;

/// Of a sample of the image's bytes.
double mean_level(const Image& image) {
  constexpr std::size_t kStep = 13;
  long total = 0, count = 0;
  for (std::size_t i = 0; i < image.bytes.size(); i += kStep, ++count) total += image.bytes[i];
  return static_cast<double>(total) / static_cast<double>(std::max(count, 1L));
}

}  // namespace

void ImageMonitorParams::describe(FieldList& fields) {
  fields.real("age_max_s", age_max_s, {0.05, 5}, "the vehicle stops after this time without a good image");
  fields.real("dark_level", dark_level, {0, 100}, "mean grey level below which an image is black");
  fields.real("bright_level", bright_level, {150, 256}, "mean grey level above which it is washed out");
}

ImageMonitor::ImageMonitor(const ImageMonitorParams& params, const VehicleDescription& vehicle,
                           const CameraDescription& camera)
    : params_(params), vehicle_(vehicle), camera_(camera) {}

const CameraImage* ImageMonitor::look(const Observation& observation) {
  move(observation);
  const auto found = std::find_if(observation.images.begin(), observation.images.end(),
                                  [&](const CameraImage& image) { return image.camera == camera_.name; });
  if (found == observation.images.end() || !found->pixels) {
    if (good_stamp_s_ && observation.stamp_s - *good_stamp_s_ > camera_.period_s) what_ = "sends no images";
    return nullptr;
  }
  if (const char* fault = fault_of(*found, observation.stamp_s)) {
    what_ = fault;
    return nullptr;
  }
  good_stamp_s_ = found->stamp_s;
  return &*found;
}

void ImageMonitor::move(const Observation& observation) {
  const Pose2 T_odom_before = poses_.empty() ? Pose2{} : poses_.back().T_odom_vehicle;
  poses_.push_back({observation.stamp_s, T_odom_before * odometry_step(vehicle_, observation.odometry)});
  const double oldest_s = observation.stamp_s - params_.age_max_s;
  while (poses_.size() > 1 && poses_[1].stamp_s <= oldest_s) poses_.pop_front();
}

/// Where the vehicle was when an image was taken, at the end of the cycle before: a late image shows less
/// motion than the odometry has reported by then.
Pose2 ImageMonitor::T_odom_taken(const CameraImage& image) const {
  const auto after = std::find_if(poses_.begin() + 1, poses_.end(),
                                  [&](const StampedPose& pose) { return pose.stamp_s > image.stamp_s; });
  return std::prev(after)->T_odom_vehicle;
}

/// Whether the image is still the same although the vehicle has moved. A vehicle that stops because of that
/// stays where it is, so this stays true until another image comes.
bool ImageMonitor::is_frozen(const CameraImage& image) {
  const Pose2 T_odom_vehicle = T_odom_taken(image);
  if (shown_ && *shown_ == *image.pixels) {
    const Pose2 T = between(T_odom_shown_, T_odom_vehicle);
    return T.position().norm() > kShownMotion_m || std::abs(T.theta) > kShownTurn_rad;
  }
  shown_ = image.pixels;
  T_odom_shown_ = T_odom_vehicle;
  return false;
}

/// nullptr if there is none.
const char* ImageMonitor::fault_of(const CameraImage& image, double now_s) {
  if (now_s - image.stamp_s > params_.age_max_s) return "is late";
  if (image.pixels->width_px != camera_.width_px || image.pixels->height_px != camera_.height_px)
    return "sends images of another size";
  if (is_frozen(image)) return "is frozen";
  const double level = mean_level(*image.pixels);
  if (level < params_.dark_level) return "sees no light";
  return level > params_.bright_level ? "is dazzled" : nullptr;
}

std::optional<std::string> ImageMonitor::trouble(double now_s) const {
  if (good_stamp_s_ && now_s - *good_stamp_s_ <= params_.age_max_s) return std::nullopt;
  return "camera " + camera_.name + " " + what_;
}

}  // namespace aisle
