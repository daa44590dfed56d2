#include "open_stream.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <set>

#include "folder_stream.hpp"
#include "pipeline_stream.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;

std::string present_devices() {
  std::set<std::string> devices;
  std::error_code error;
  for (fs::directory_iterator entry("/dev", error), end; !error && entry != end; entry.increment(error)) {
    if (entry->path().filename().string().starts_with("video")) devices.insert(entry->path().string());
  }
  return devices.empty() ? "this machine has no /dev/video*"
                         : fmt::format("there are {}", fmt::join(devices, ", "));
}

Problems device_problems(const std::string& device) {
  std::error_code error;
  if (fs::is_character_file(device, error)) return {};
  return {{{device}, "is no camera: " + present_devices()}};
}

}  // namespace

Result<std::unique_ptr<ImageStream>> open_stream(const CameraSource& source) {
  if (!source.folder.empty()) return FolderStream::open(source);
  if (!source.device.empty()) {
    if (Problems problems = device_problems(source.device); !problems.empty()) return problems;
  }
  return PipelineStream::open(source);
}

}  // namespace aisle
