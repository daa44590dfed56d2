#include "aisle/vehicle/observation.hpp"

namespace aisle {

const CameraImage* present_image(const Observation& observation, const std::string& camera, double cycle_s) {
  for (const CameraImage& image : observation.images) {
    if (image.camera == camera && observation.stamp_s - image.stamp_s < cycle_s / 2) return &image;
  }
  return nullptr;
}

}  // namespace aisle
