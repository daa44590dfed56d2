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

}  // namespace aisle
