#include <algorithm>
#include <filesystem>

#include "aisle/formats/bags/bag_reader.hpp"
#include "aisle/formats/image_sequences/image_sequence.hpp"
#include "bags/bag_files.hpp"
#include "image_sequences/bag_images.hpp"
#include "image_sequences/donkey_tub.hpp"
#include "image_sequences/image_folder.hpp"
#include "natural_order.hpp"

namespace aisle {
namespace fs = std::filesystem;

namespace {

bool has_ending(const fs::path& file, std::initializer_list<const char*> endings) {
  const std::string name = file.filename().string();
  return std::any_of(endings.begin(), endings.end(),
                     [&](const char* ending) { return name.ends_with(ending); });
}

}  // namespace

Result<std::unique_ptr<ImageSequence>> open_image_sequence(const std::string& recording,
                                                           const ImageSequenceOptions& options) {
  const fs::path path(recording);
  std::error_code error;
  if (!fs::exists(path, error)) return Problem{{recording}, "no such file or folder"};
  if (fs::is_directory(path, error)) {
    if (is_tub(path)) return open_tub(path, options);
    if (!files_in_natural_order(path, has_bag_name).empty()) return open_bag_images(path, options);
    return open_image_folder(path, options);
  }
  if (has_ending(path, {".tar", ".tar.gz", ".tgz", ".zip", ".tar.bz2", ".tar.xz"}))
    return Problem{{recording}, "is an archive: unpack it, and give the folder with manifest.json in it"};
  if (is_bag(path)) return open_bag_images(path, options);
  if (path.filename() == "manifest.json") return open_tub(path.parent_path(), options);
  if (has_ending(path, {".csv", ".csv.gz"})) return open_image_csv(path, options);
  return Problem{{recording},
                 "is no recording that is read: the folder of a Donkeycar tub, a list of images (CSV), a "
                 "folder of images, or a ROS bag"};
}

std::vector<fs::path> images_in_folder(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error) || is_tub(folder)) return {};
  if (!files_in_natural_order(folder, has_bag_name).empty()) return {};
  return listless_images(folder);
}

}  // namespace aisle
