#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "aisle/core/problem.hpp"
#include "aisle/core/result.hpp"

namespace aisle {

/// A verb's `--out DIR`. Checked before the work starts, so that an hour's work is never lost to a bad path;
/// existing results are replaced only with `--force`.
class OutputDirectory {
 public:
  /// `names` are the files that the verb is going to write. The directory is created.
  static Result<OutputDirectory> open(const std::filesystem::path& directory, bool force,
                                      const std::vector<std::string>& names);

  std::filesystem::path path(std::string_view name) const { return directory_ / name; }

 private:
  explicit OutputDirectory(std::filesystem::path directory) : directory_(std::move(directory)) {}

  std::filesystem::path directory_;
};

}  // namespace aisle
