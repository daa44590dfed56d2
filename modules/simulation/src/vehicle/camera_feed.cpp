#include "aisle/simulation/vehicle/camera_feed.hpp"

#include <utility>

namespace aisle {

void CameraFeed::take(CameraPicture picture, const CameraTrouble& trouble) {
  if (trouble.frozen && last_good_) {
    picture.image = last_good_;
  } else {
    last_good_ = picture.image;
  }
  if (trouble.dropped) return;
  const double due_s = picture.stamp_s + trouble.delay_s;
  underway_.push_back({due_s, std::move(picture)});
}

std::optional<CameraPicture> CameraFeed::deliver(double now_s) {
  std::optional<CameraPicture> arrived;
  while (!underway_.empty() && underway_.front().due_s <= now_s) {
    arrived = std::move(underway_.front().picture);
    underway_.pop_front();
  }
  return arrived;
}

}  // namespace aisle
