#pragma once

#include <filesystem>
#include <optional>

#include "aisle/commands/outcome.hpp"

namespace aisle {

struct ShowWorldOptions {
  std::filesystem::path world;
  std::optional<std::filesystem::path> svg;
  std::optional<std::filesystem::path> png;
  bool force = false;  ///< replace images that are there already
};

/// `aisle sim show WORLD`: draws a world's plan and says what is in it and where a vehicle can get.
Result<Outcome> run_show_world(const ShowWorldOptions& options, Console& console);

}  // namespace aisle
