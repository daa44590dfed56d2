#include "aisle/simulation/vehicle/camera_feed.hpp"

#include <utility>

namespace aisle {

void CameraFeed::take(CameraImage image, const CameraTrouble& trouble) {
  if (trouble.frozen && last_good_) {
    image.pixels = last_good_;
  } else {
    last_good_ = image.pixels;
  }
  if (trouble.dropped) return;
  const double due_s = image.stamp_s + trouble.delay_s;
  underway_.push_back({due_s, std::move(image)});
}

std::optional<CameraImage> CameraFeed::deliver(double now_s) {
  std::optional<CameraImage> arrived;
  while (!underway_.empty() && underway_.front().due_s <= now_s) {
    arrived = std::move(underway_.front().image);
    underway_.pop_front();
  }
  return arrived;
}

}  // namespace aisle
