#pragma once

#include <optional>
#include <span>
#include <vector>

#include "aisle/matching/pose_alignment.hpp"

namespace aisle {

/// Searches for the sensor's pose around a guess that the walls contradict. Headings come from the
/// differences between segments and walls, translations from signature matching (C99 Algorithm 2) at each
/// heading; every combination is fitted to the walls. nullopt unless the best fits well and clearly better
/// than the guess.
std::optional<Pose2> find_pose_near(const Pose2& guess, std::span<const SensedSegment> segments,
                                    std::span<const WallEstimate> walls, std::span<const int> window,
                                    double path_m, double reach_m, PoseAligner& aligner);

}  // namespace aisle
