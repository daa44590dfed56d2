#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/plan_reading.hpp"
#include "aisle/simulation/buildings/random_building.hpp"
#include "aisle/simulation/paths/round_trip.hpp"

namespace aisle {

/// The plan is unused if `seed` is set.
struct ConvertOptions : PlanOptions {
  RoundTripParams run;
  std::optional<std::uint64_t> seed;  ///< makes a random building of this seed
  RandomBuildingRecipe recipe;
  bool dress = false;  ///< add doors, lamps and posters to a plan; random buildings have them
  std::filesystem::path out;
  bool force = false;
};

/// `aisle convert PLAN|--random SEED -o WORLD`: makes a world from a plan, or at random.
Result<Outcome> run_convert(const ConvertOptions& options, Console& console);

}  // namespace aisle
