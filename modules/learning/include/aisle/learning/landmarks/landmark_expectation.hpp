#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "aisle/maps/landmark_map.hpp"
#include "aisle/vehicle/floor_in_image.hpp"
#include "aisle/vision/lines/landmark_sightings.hpp"

namespace aisle {

inline constexpr double kFloorPointFarthest_m = 7;  ///< from the vehicle; farther floor points are vague

/// A sure landmark that should be seen in an image from the believed pose.
struct ExpectedLandmark {
  int landmark = 0;
  bool is_seen = false;
};

/// All sure landmarks that should be seen. One is seen if a line with the same brighter side is within two
/// standard deviations of it: those of the sighting, the landmark and the pose combined. Other lines in the
/// image do not count.
/// @param landmark_sigma_m  least sigma of a landmark's position
std::vector<ExpectedLandmark> expected_landmarks(const LandmarkMap& map, const UncertainPose2& T_map_believed,
                                                 std::span<const LandmarkSighting> image,
                                                 double landmark_sigma_m);

/// @return the number of lines in the image that show a sure landmark in the same sense, anywhere in the view
std::size_t known_sightings(const LandmarkMap& map, const UncertainPose2& T_map_believed,
                            std::span<const LandmarkSighting> image, double landmark_sigma_m);

/// @return the number of sure landmarks whose floor points lie in the camera's image and that were seen from
///         about this side and distance before, at most kFloorPointFarthest_m away, whatever the image shows
std::size_t landmarks_in_image(const LandmarkMap& map, const Pose2& T_map_vehicle, const FloorInImage& floor);

}  // namespace aisle
