#pragma once

#include <filesystem>

namespace aisle {

/// What the server may show of the file system. Empty: nothing.
struct LiveFolders {
  std::filesystem::path web;        ///< the page that was built
  std::filesystem::path sessions;   ///< a folder of sessions
  std::filesystem::path buildings;  ///< a folder of building files
};

}  // namespace aisle
