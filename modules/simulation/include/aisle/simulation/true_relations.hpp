#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "aisle/core/random.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// The true pose of one scan seen from another: what an estimated trajectory is scored against.
struct TrueRelation {
  std::size_t first = 0;  ///< index of a scan
  std::size_t second = 0;
  Pose2 T_first_second;
};

/// For every metre of the way one relation to the scan a metre farther on, and, where the vehicle came near
/// that place again at another time, one to a scan drawn from that later visit.
std::vector<TrueRelation> true_relations(std::span<const Pose2> T_world_vehicle, Random& random);

/// One "first second x y yaw" a line, metres and radians.
std::string relations_text(std::span<const TrueRelation> relations);

}  // namespace aisle
