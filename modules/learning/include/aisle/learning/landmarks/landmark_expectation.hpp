#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "aisle/maps/landmark_map.hpp"
#include "aisle/vehicle/floor_in_image.hpp"
#include "aisle/vision/lines/landmark_sightings.hpp"

namespace aisle {

inline constexpr double kFloorPointFarthest_m = 7;  ///< from the vehicle: lines' feet farther away are vague

/// A sure landmark that should be seen in an image from where the vehicle believes to be.
struct ExpectedLandmark {
  int landmark = 0;
  bool is_seen = false;
};

/// A landmark is seen where a line of its brighter side stands within two standard deviations of it: those of
/// the sighting, the landmark and the pose together. What else the image shows does not count.
/// @param landmark_sigma_m  least error of a landmark's place
std::vector<ExpectedLandmark> expected_landmarks(const LandmarkMap& map, const UncertainPose2& T_map_believed,
                                                 std::span<const LandmarkSighting> image,
                                                 double landmark_sigma_m);

/// @return so many lines of the image show a sure landmark, wherever in the view, in the same sense
std::size_t known_sightings(const LandmarkMap& map, const UncertainPose2& T_map_believed,
                            std::span<const LandmarkSighting> image, double landmark_sigma_m);

/// @return so many sure landmarks have their feet in the camera's image and were seen from about this side
/// and distance before, at most kFloorPointFarthest_m away: whatever the image shows
std::size_t landmarks_in_image(const LandmarkMap& map, const Pose2& T_map_vehicle, const FloorInImage& floor);

}  // namespace aisle
