#pragma once

#include <filesystem>

#include "aisle/commands/explore.hpp"
#include "aisle/commands/learn.hpp"

namespace aisle {

/// Learns, and keeps the building file alone, where nothing is yet.
Result<Outcome> learn_into(const LearnOptions& options, const std::filesystem::path& building,
                           Console& console);

/// Explores, and keeps the building file alone; an empty path: nothing.
Result<Outcome> explore_into(const ExploreOptions& options, const std::filesystem::path& building,
                             Console& console);

}  // namespace aisle
