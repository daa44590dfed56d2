#pragma once

#include <string>

#include "aisle/commands/drive.hpp"

namespace aisle {

struct TeachOptions {
  DriveOptions drive;  ///< `out` is needed
  std::string method = "landmarks";
  std::string route = "route";      ///< its name
  bool shows_view_pattern = false;  ///< of a taught place, by a scripted person
};

/// `aisle teach WORLD`: a person drives a route once, and the session keeps what the method will learn from.
Result<Outcome> run_teach(const TeachOptions& options, Console& console);

}  // namespace aisle
