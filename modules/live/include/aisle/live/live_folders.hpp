#pragma once

#include <filesystem>

namespace aisle {

/// Folders that the server may show; an empty path shows nothing.
struct LiveFolders {
  std::filesystem::path web;        ///< the built web page
  std::filesystem::path sessions;   ///< a folder of sessions
  std::filesystem::path buildings;  ///< a folder of building files
};

}  // namespace aisle
