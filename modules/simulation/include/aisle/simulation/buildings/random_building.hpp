#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "aisle/core/problem.hpp"
#include "aisle/core/random.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

enum class BuildingKind {
  kOffice,  ///< corridors that meet in an L, T or cross, with rooms behind doors on both sides
  kRing,    ///< a corridor round a core, rooms on its outer side and perhaps in the core
  kComb,    ///< a corridor with dead ends on one side
  kHall,    ///< a wide hall with pillars that corridors lead to
};

inline constexpr BuildingKind kBuildingKinds[] = {BuildingKind::kOffice, BuildingKind::kRing,
                                                  BuildingKind::kComb, BuildingKind::kHall};

std::string_view name_of(BuildingKind kind);

struct RandomBuildingRecipe {
  BuildingKind kind = BuildingKind::kOffice;
  std::optional<double> size_m;            ///< length of its longest corridor, 12 .. 200; else random
  std::optional<double> corridor_width_m;  ///< 1.2 .. 5; else random for each corridor, 1.2 .. 3

  Problems problems() const;
};

/// A random building, the same for the same recipe and seed: corridors, rooms behind doors of which some are
/// open, alcoves, light furniture, lamps, posters, floor and brightness; a start, a tour through all
/// corridors and back, and places. A vehicle 0.6 m wide gets through every corridor and open door.
World random_building(const RandomBuildingRecipe& recipe, Random random);

}  // namespace aisle
