#pragma once

#include <span>
#include <vector>

#include "aisle/geometry/pose2.hpp"
#include "aisle/vision/lines/landmark_sightings.hpp"

namespace aisle {

/// Whether an image shows a line that another one showed: the same side is brighter, and the floor points
/// agree within both errors and that of the odometry in between.
bool shows(std::span<const LandmarkSighting> image, const LandmarkSighting& line);

/// Share of an image's lines that another one shows, too; NaN for an empty image.
double shown_share(std::span<const LandmarkSighting> image, std::span<const LandmarkSighting> other);

/// Transforms sightings into the vehicle frame after a motion.
void carry_sightings(std::vector<LandmarkSighting>& scene, const Pose2& T_now_before);

}  // namespace aisle
