#pragma once
/// Which files a bag has.

#include <filesystem>
#include <string>
#include <vector>

#include "aisle/core/result.hpp"

namespace aisle {

struct BagFiles {
  std::vector<std::filesystem::path> paths;  ///< at least one
  bool in_recorded_order = false;            ///< metadata.yaml gives the order; else they are sorted by name
  Problems warnings;
};

/// A file by itself, or the files of a folder: those that its metadata.yaml lists, or all that look like a
/// bag's.
Result<BagFiles> bag_files(const std::filesystem::path& path);

/// Whether a name ends as those of bags do: .db3, .mcap, .bag, .bag.active, each perhaps followed by .zstd.
bool has_bag_name(const std::filesystem::path& path);

}  // namespace aisle
