#pragma once

#include <span>
#include <vector>

#include "aisle/geometry/pose2.hpp"
#include "aisle/vision/lines/landmark_sightings.hpp"

namespace aisle {

/// Whether a picture shows a line that another one showed: of one brighter side, and the feet agree by both
/// errors and that of the odometry between the two.
bool shows(std::span<const LandmarkSighting> picture, const LandmarkSighting& line);

/// How much of a picture another one shows too. NaN of an empty picture.
double shown_share(std::span<const LandmarkSighting> picture, std::span<const LandmarkSighting> other);

/// As they are seen after the vehicle has moved.
void carry_sightings(std::vector<LandmarkSighting>& scene, const Pose2& T_now_before);

}  // namespace aisle
