#pragma once
/// Folders of images, and lists of images in comma-separated values: docs/formats/image-sequences.md

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/formats/image_sequences/image_sequence.hpp"
#include "image_sequences/image_list.hpp"

namespace aisle {

/// Reads a list of images. A row that cannot be read is left out and counted.
/// @param file  of the list; images are named relative to its folder
Result<ImageList> parse_image_csv(std::string_view text, const std::filesystem::path& file,
                                  const ImageSequenceOptions& options);

Result<std::unique_ptr<ImageSequence>> open_image_csv(const std::filesystem::path& file,
                                                      const ImageSequenceOptions& options);

/// By its list if it has one; else all its images in natural order, which needs a rate.
Result<std::unique_ptr<ImageSequence>> open_image_folder(const std::filesystem::path& folder,
                                                         const ImageSequenceOptions& options);

/// The images of a folder in natural order; none if it has a list.
std::vector<std::filesystem::path> listless_images(const std::filesystem::path& folder);

}  // namespace aisle
