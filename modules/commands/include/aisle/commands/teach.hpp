#pragma once

#include <string>

#include "aisle/commands/drive.hpp"

namespace aisle {

struct TeachOptions {
  DriveOptions drive;  ///< `out` must be set
  std::string method = "landmarks";
  std::string route = "route";      ///< name of the taught route
  bool shows_view_pattern = false;  ///< a scripted person shows a taught place from 63 poses around it
};

/// `aisle teach WORLD`: a person drives a route once, and the session records what the method learns from.
Result<Outcome> run_teach(const TeachOptions& options, Console& console);

}  // namespace aisle
