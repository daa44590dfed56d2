#pragma once

#include <mutex>
#include <vector>

#include "aisle/vehicle/camera_description.hpp"
#include "aisle/vehicle/observation.hpp"
#include "robot_intake.hpp"

namespace aisle {

/// The newest image of each camera that is not from after a moment, which is taken away with those before it;
/// an image of stamp 0 where none is.
std::vector<ArrivedImage> take_images(RobotState& state, double until_s);

/// The pixels of those that came, each as its camera is described; the others are counted as unreadable.
/// Decodes without the lock: that takes milliseconds, and more arrives meanwhile.
std::vector<CameraImage> decoded(const std::vector<ArrivedImage>& arrived,
                                 const std::vector<CameraDescription>& cameras, RobotIntake& intake,
                                 std::unique_lock<std::mutex>& lock);

}  // namespace aisle
