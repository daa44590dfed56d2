#pragma once

#include <filesystem>

#include "aisle/core/result.hpp"

namespace aisle {

/// A new directory for files that are needed while a recording is read; it goes with the object.
class UnpackingDirectory {
 public:
  static Result<UnpackingDirectory> create();

  UnpackingDirectory(UnpackingDirectory&& other) noexcept;
  UnpackingDirectory& operator=(UnpackingDirectory&& other) noexcept;
  ~UnpackingDirectory();

  const std::filesystem::path& path() const { return path_; }

 private:
  explicit UnpackingDirectory(std::filesystem::path path) : path_(std::move(path)) {}

  std::filesystem::path path_;  ///< empty: none
};

}  // namespace aisle
