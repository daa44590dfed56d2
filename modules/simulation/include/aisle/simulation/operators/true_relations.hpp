#pragma once

#include <span>
#include <string>
#include <vector>

#include "aisle/core/random.hpp"
#include "aisle/vehicle/pose_relation.hpp"

namespace aisle {

/// The relations that an estimated trajectory is scored against: for every metre driven one relation to the
/// scan a metre farther on and, where the vehicle came near that place again later, one to a random scan of
/// that visit.
std::vector<PoseRelation> true_relations(std::span<const Pose2> T_world_vehicle, Random& random);

/// The relations as a file that scoring reads: "i1 i2 x y yaw" per line, metres and radians.
std::string relations_text(std::span<const PoseRelation> relations);

}  // namespace aisle
