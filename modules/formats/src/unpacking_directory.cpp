#include "unpacking_directory.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

namespace aisle {
namespace fs = std::filesystem;

Result<UnpackingDirectory> UnpackingDirectory::create() {
  std::error_code error;
  std::string name = (fs::temp_directory_path(error) / "aisle-unpacked-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    return Problem{{name}, fmt::format("cannot be made: {}", std::strerror(errno))};
  return UnpackingDirectory(name);
}

UnpackingDirectory::UnpackingDirectory(UnpackingDirectory&& other) noexcept
    : path_(std::exchange(other.path_, {})) {}

UnpackingDirectory& UnpackingDirectory::operator=(UnpackingDirectory&& other) noexcept {
  std::swap(path_, other.path_);
  return *this;
}

UnpackingDirectory::~UnpackingDirectory() {
  std::error_code error;
  if (!path_.empty()) fs::remove_all(path_, error);
}

}  // namespace aisle
