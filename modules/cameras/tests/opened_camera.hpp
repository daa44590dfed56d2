#pragma once

#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>

#include "aisle/cameras/live_camera.hpp"
#include "patience.hpp"

namespace aisle {

inline std::unique_ptr<LiveCamera> opened(const CameraSource& source) {
  auto camera = LiveCamera::open(source);
  if (!camera) throw std::runtime_error(to_string(camera.problems()));
  return std::move(*camera);
}

inline std::string refusal(const CameraSource& source) {
  const auto camera = LiveCamera::open(source);
  return camera ? "" : to_string(camera.problems());
}

/// The next image of a camera that has one.
inline LiveImage next_image(LiveCamera& camera) {
  auto image = camera.newest(kPatience);
  if (!image) throw std::runtime_error("no image: " + camera.problem());
  return std::move(*image);
}

/// Waits until `is_so()`, whatever images come meanwhile. @return whether it is
template <class Condition>
bool eventually(LiveCamera& camera, const Condition& is_so) {
  for (const auto end = std::chrono::steady_clock::now() + kPatience;
       std::chrono::steady_clock::now() < end;) {
    if (is_so()) return true;
    camera.newest(std::chrono::milliseconds(20));
  }
  return false;
}

inline bool eventually_says(LiveCamera& camera, const std::string& words) {
  return eventually(camera, [&] { return camera.problem().find(words) != std::string::npos; });
}

}  // namespace aisle
