#pragma once

#include <span>
#include <vector>

#include "aisle/geometry/pose2.hpp"
#include "aisle/vision/lines/landmark_sightings.hpp"

namespace aisle {

/// Whether an image shows a line that another one showed: of one brighter side, and the feet agree by both
/// errors and that of the odometry between the two.
bool shows(std::span<const LandmarkSighting> image, const LandmarkSighting& line);

/// How much of an image another one shows too. NaN of an empty image.
double shown_share(std::span<const LandmarkSighting> image, std::span<const LandmarkSighting> other);

/// As they are seen after the vehicle has moved.
void carry_sightings(std::vector<LandmarkSighting>& scene, const Pose2& T_now_before);

}  // namespace aisle
