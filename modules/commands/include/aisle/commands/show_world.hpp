#pragma once

#include <filesystem>
#include <optional>

#include "aisle/commands/outcome.hpp"

namespace aisle {

struct ShowWorldOptions {
  std::filesystem::path world;
  std::optional<std::filesystem::path> svg;
  std::optional<std::filesystem::path> png;
  bool force = false;  ///< overwrite existing images
};

/// `aisle sim show WORLD`: draws a world's plan, lists its contents and measures where a vehicle can get to.
Result<Outcome> run_show_world(const ShowWorldOptions& options, Console& console);

}  // namespace aisle
