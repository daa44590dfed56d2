#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "aisle/core/problem.hpp"
#include "aisle/core/result.hpp"

namespace aisle {

/// One file of a verb's results.
struct OutputFile {
  std::string role;  ///< its meaning to the verb: "building"
  std::string name;  ///< in the output directory
  std::string bytes;
};

/// A verb's `--out DIR`. It is checked before the work starts, so that an hour's work is never lost to a bad
/// path. Existing results are overwritten only with `--force`. A directory that was created for results is
/// removed if none are written.
class OutputDirectory {
 public:
  OutputDirectory(OutputDirectory&&) noexcept = default;
  ~OutputDirectory();

  /// Creates the directory, and removes what a run left there that was killed while it wrote. `names` are the
  /// files that the verb is going to write.
  static Result<OutputDirectory> open(const std::filesystem::path& directory, bool force,
                                      const std::vector<std::string>& names);

  /// The same for a verb with an optional directory: nullopt if `directory` is empty.
  static Result<std::optional<OutputDirectory>> open_if_named(const std::filesystem::path& directory,
                                                              bool force,
                                                              const std::vector<std::string>& names);

  std::filesystem::path path(std::string_view name) const { return directory_ / name; }

  /// Writes all files or, if one of them cannot be written, none.
  /// @return role -> path
  Result<std::map<std::string, std::string>> write(const std::vector<OutputFile>& files) const;

 private:
  OutputDirectory(std::filesystem::path directory, std::vector<std::filesystem::path> made)
      : made_(std::move(made)), directory_(std::move(directory)) {}

  /// Where files are written before they are put in place.
  std::filesystem::path unfinished() const { return directory_ / ".unfinished"; }

  std::vector<std::filesystem::path> made_;  ///< innermost first
  std::filesystem::path directory_;
};

}  // namespace aisle
