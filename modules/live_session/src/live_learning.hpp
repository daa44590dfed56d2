#pragma once

#include <filesystem>

#include "aisle/commands/explore.hpp"
#include "aisle/commands/learn.hpp"

namespace aisle {

/// Learns, and keeps only the building file. `building` must not exist yet.
Result<Outcome> learn_into(const LearnOptions& options, const std::filesystem::path& building,
                           Console& console);

/// Explores, and keeps only the building file; with an empty path, nothing.
Result<Outcome> explore_into(const ExploreOptions& options, const std::filesystem::path& building,
                             Console& console);

}  // namespace aisle
