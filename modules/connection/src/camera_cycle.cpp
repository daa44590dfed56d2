#include "camera_cycle.hpp"

#include <utility>

namespace aisle {

std::vector<ArrivedImage> take_images(RobotState& state, double until_s) {
  std::vector<ArrivedImage> taken;
  taken.reserve(state.cameras.size());
  for (ArrivingImages& camera : state.cameras) {
    std::deque<ArrivedImage>& images = camera.images;
    ArrivedImage newest;
    while (!images.empty() && images.front().stamp_s <= until_s) {
      if (newest.stamp_s > 0) ++state.counts.images_skipped;
      newest = std::move(images.front());
      images.pop_front();
    }
    taken.push_back(std::move(newest));
  }
  return taken;
}

std::vector<CameraImage> decoded(const std::vector<ArrivedImage>& arrived,
                                 const std::vector<CameraDescription>& cameras, RobotIntake& intake,
                                 std::unique_lock<std::mutex>& lock) {
  std::vector<CameraImage> images;
  images.reserve(arrived.size());
  for (std::size_t i = 0; i < arrived.size(); ++i) {
    if (arrived[i].stamp_s == 0) continue;
    lock.unlock();
    const auto pixels = intake.pixels_of(arrived[i], i);
    lock.lock();
    if (pixels && (*pixels)->width_px == cameras[i].width_px &&
        (*pixels)->height_px == cameras[i].height_px) {
      images.push_back({cameras[i].name, arrived[i].stamp_s, *pixels});
    } else {
      intake.count_unreadable(intake.images(i).type);
    }
  }
  return images;
}

}  // namespace aisle
