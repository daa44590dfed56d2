#include "image_sequences/image_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "aisle/formats/whole_file.hpp"
#include "image_sequences/stamp_order.hpp"
#include "natural_order.hpp"

namespace aisle {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kListBytesMax = std::size_t{256} << 20;

/// The file's ending in lower-case letters: cameras write IMG_1.JPG.
std::string ending_of(const fs::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

bool is_image(const fs::path& file) {
  constexpr std::array kEndings = {".jpg", ".jpeg", ".png", ".ppm", ".pgm", ".bmp", ".tif", ".tiff"};
  return std::find(kEndings.begin(), kEndings.end(), ending_of(file)) != kEndings.end();
}

bool is_csv(const fs::path& file) {
  return ending_of(file) == ".csv";
}

Result<std::unique_ptr<ImageSequence>> checked_sequence(ImageList list) {
  if (Problems problems = order_stamps(list); !problems.empty()) return problems;
  if (!list.has_odometry) {
    list.warnings.push_back({{list.recording.string()},
                             "has no odometry: nothing that needs it, such as aisle learn, works with this "
                             "recording"});
  }
  return sequence_of(std::move(list));
}

}  // namespace

Result<std::unique_ptr<ImageSequence>> open_image_csv(const fs::path& file,
                                                      const ImageSequenceOptions& options) {
  const auto text = read_whole_file(file, kListBytesMax);
  if (!text) return text.problems();
  auto list = parse_image_csv(*text, file, options);
  if (!list) return list.problems();
  return checked_sequence(std::move(*list));
}

std::vector<fs::path> listless_images(const fs::path& folder) {
  if (!files_in_natural_order(folder, is_csv).empty()) return {};
  return files_in_natural_order(folder, is_image);
}

Result<std::unique_ptr<ImageSequence>> open_image_folder(const fs::path& folder,
                                                         const ImageSequenceOptions& options) {
  const std::vector<fs::path> lists = files_in_natural_order(folder, is_csv);
  if (lists.size() > 1) {
    return Problem{{folder.string()},
                   fmt::format("has {} lists, {} and others: give the one that is meant, not the folder",
                               lists.size(), lists.front().filename().string())};
  }
  if (!lists.empty()) return open_image_csv(lists.front(), options);
  ImageList list{.recording = folder, .images = {}, .unreadable = {}, .warnings = {}};
  for (fs::path& file : files_in_natural_order(folder, is_image))
    list.images.push_back({.stamp_s = 0, .file = std::move(file)});
  if (list.images.empty()) {
    return Problem{
        {folder.string()},
        "is no recording that is read: a Donkeycar tub (manifest.json), a list of images (*.csv), or "
        "a folder of images"};
  }
  if (!options.rate_hz) {
    return Problem{
        {folder.string()},
        fmt::format("has {} images without stamps: --image-rate HZ gives their rate, or a list of them "
                    "(CSV: stamp_s,file) their stamps",
                    list.images.size())};
  }
  for (std::size_t i = 0; i < list.images.size(); ++i)
    list.images[i].stamp_s = static_cast<double>(i) / *options.rate_hz;
  return checked_sequence(std::move(list));
}

}  // namespace aisle
