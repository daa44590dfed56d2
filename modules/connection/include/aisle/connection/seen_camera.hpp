#pragma once

#include <string>

#include "aisle/connection/topic_pace.hpp"
#include "aisle/vehicle/camera_description.hpp"

namespace aisle {

/// A camera of a connection, as its images are taken.
struct SeenCamera {
  CameraDescription camera;
  std::string images;      ///< their topic, or the name of their source
  std::string lens_from;   ///< "/camera/camera_info", "the vehicle file"
  std::string mount_from;  ///< "/tf_static", "the vehicle file"
  TopicPace pace;
};

}  // namespace aisle
