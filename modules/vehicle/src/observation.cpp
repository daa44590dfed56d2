#include "aisle/vehicle/observation.hpp"

namespace aisle {

const CameraPicture* present_picture(const Observation& observation, const std::string& camera,
                                     double cycle_s) {
  for (const CameraPicture& picture : observation.pictures) {
    if (picture.camera == camera && observation.stamp_s - picture.stamp_s < cycle_s / 2) return &picture;
  }
  return nullptr;
}

}  // namespace aisle
