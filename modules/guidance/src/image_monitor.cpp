#include "aisle/guidance/image_monitor.hpp"

#include <algorithm>
#include <cmath>

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

const CameraImage* ImageMonitor::look(const Observation& observation, const OdometryHistory& odometry) {
  const auto found = std::find_if(observation.images.begin(), observation.images.end(),
                                  [&](const CameraImage& image) { return image.camera == camera_.name; });
  if (found == observation.images.end() || !found->pixels) {
    if (good_stamp_s_ && observation.stamp_s - *good_stamp_s_ > camera_.period_s) what_ = "sends no images";
    return nullptr;
  }
  if (const char* fault = fault_of(*found, odometry)) {
    what_ = fault;
    return nullptr;
  }
  good_stamp_s_ = found->stamp_s;
  return &*found;
}

/// Whether the image is still the same although the vehicle has moved. A vehicle that stops because of that
/// stays where it is, so this stays true until another image comes.
bool ImageMonitor::is_frozen(const CameraImage& image, const Pose2& T_odom_taken) {
  if (shown_ && *shown_ == *image.pixels) {
    const Pose2 T = between(T_odom_shown_, T_odom_taken);
    return T.position().norm() > kShownMotion_m || std::abs(T.theta) > kShownTurn_rad;
  }
  shown_ = image.pixels;
  T_odom_shown_ = T_odom_taken;
  return false;
}

/// nullptr if there is none.
const char* ImageMonitor::fault_of(const CameraImage& image, const OdometryHistory& odometry) {
  if (odometry.stamp_s() - image.stamp_s > params_.age_max_s) return "is late";
  if (image.pixels->width_px != camera_.width_px || image.pixels->height_px != camera_.height_px)
    return "sends images of another size";
  if (is_frozen(image, odometry.T_odom_at(image.stamp_s))) return "is frozen";
  const double level = mean_level(*image.pixels);
  if (level < params_.dark_level) return "sees no light";
  return level > params_.bright_level ? "is dazzled" : nullptr;
}

std::optional<std::string> ImageMonitor::trouble(double now_s) const {
  if (good_stamp_s_ && now_s - *good_stamp_s_ <= params_.age_max_s) return std::nullopt;
  return "camera " + camera_.name + " " + what_;
}

}  // namespace aisle
