#pragma once

#include <span>
#include <string>
#include <vector>

#include "aisle/core/random.hpp"
#include "aisle/vehicle/pose_relation.hpp"

namespace aisle {

/// What an estimated trajectory is scored against: for every metre of the path one relation to the scan a
/// metre farther on, and, where the vehicle came near that place again at another time, one to a scan drawn
/// from that later visit.
std::vector<PoseRelation> true_relations(std::span<const Pose2> T_world_vehicle, Random& random);

/// The relations as a file that scoring reads: "i1 i2 x y yaw" a line, metres and radians.
std::string relations_text(std::span<const PoseRelation> relations);

}  // namespace aisle
