#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace aisle {

/// A folder for a test's images; gone with the object.
class ImageFolderPlace {
 public:
  ImageFolderPlace()
      : path_(std::filesystem::temp_directory_path() / ("aisle_cameras_" + std::to_string(::getpid()))) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ImageFolderPlace(const ImageFolderPlace&) = delete;
  ImageFolderPlace& operator=(const ImageFolderPlace&) = delete;
  ~ImageFolderPlace() { std::filesystem::remove_all(path_); }

  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
  }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace aisle
