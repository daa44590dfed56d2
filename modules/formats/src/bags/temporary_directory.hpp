#pragma once

#include <filesystem>

#include "aisle/core/result.hpp"

namespace aisle {

/// A new directory for files that are needed while a bag is read; it goes with the object.
class TemporaryDirectory {
 public:
  static Result<TemporaryDirectory> create();

  TemporaryDirectory(TemporaryDirectory&& other) noexcept;
  TemporaryDirectory& operator=(TemporaryDirectory&& other) noexcept;
  ~TemporaryDirectory();

  const std::filesystem::path& path() const { return path_; }

 private:
  explicit TemporaryDirectory(std::filesystem::path path) : path_(std::move(path)) {}

  std::filesystem::path path_;  ///< empty: none
};

}  // namespace aisle
