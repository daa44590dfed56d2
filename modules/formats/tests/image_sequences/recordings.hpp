#pragma once
/// Small recordings to test with.

#include <cmath>
#include <filesystem>
#include <string>

#include "aisle/formats/image_sequences/image_sequence.hpp"
#include "aisle/formats/images/image_file.hpp"
#include "session_samples.hpp"
#include "written_file.hpp"

namespace aisle {

inline std::string sample_jpeg(int seed, int width = 32, int height = 24) {
  Random random(static_cast<std::uint64_t>(seed));
  return jpeg_bytes(sample_image(width, height, 3, random), 80);
}

/// A line of a catalog, 50 ms after that of the index before.
inline std::string catalog_line(int index, long time_ms) {
  return R"({"_index": )" + std::to_string(index) + R"(, "_timestamp_ms": )" + std::to_string(time_ms) +
         R"(, "cam/image_array": ")" + std::to_string(index) +
         R"(_cam_image_array_.jpg", "user/angle": -0.25, "user/mode": "user", "user/throttle": 0.7})" + "\n";
}

inline constexpr long kTubStart_ms = 1626922343713;

inline std::string catalog_line(int index) {
  return catalog_line(index, kTubStart_ms + 50L * index);
}

inline std::string tub_manifest(const std::string& deleted = "") {
  return R"(["cam/image_array", "user/angle", "user/throttle", "user/mode"]
["image_array", "float", "float", "str"]
{}
{"created_at": 1626921538.008834}
{"paths": ["catalog_0.catalog"], "current_index": 10, "max_len": 1000, "deleted_indexes": [)" +
         deleted + "]}\n";
}

inline void write_tub_images(const std::filesystem::path& tub, int count) {
  for (int i = 0; i < count; ++i)
    write_file(tub / "images" / (std::to_string(i) + "_cam_image_array_.jpg"), sample_jpeg(i));
}

/// All that is left of a sequence.
inline std::vector<TimedImage> read_all(ImageSequence& sequence) {
  std::vector<TimedImage> images;
  while (true) {
    auto image = sequence.next();
    if (!image.ok() || !image->has_value()) return images;
    images.push_back(std::move(**image));
  }
}

}  // namespace aisle
