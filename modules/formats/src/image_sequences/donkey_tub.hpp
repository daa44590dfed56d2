#pragma once
/// Tubs: the recordings of Donkeycars. docs/formats/image-sequences.md

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/formats/image_sequences/image_sequence.hpp"
#include "image_sequences/left_out.hpp"

namespace aisle {

/// What the manifest.json of a tub says.
struct TubManifest {
  std::vector<std::string> catalogs;  ///< names of files beside it
  std::set<std::int64_t> deleted_indexes;
  std::vector<std::string> image_keys = {"cam/image_array"};  ///< at least one
};

/// One line of a catalog.
struct TubRecord {
  std::int64_t index = 0;
  double stamp_s = 0;
  std::string image;  ///< the name of a file in the folder images
  std::optional<RecordedControls> controls;
};

Result<TubManifest> parse_tub_manifest(std::string_view text, const std::string& name);

/// The records of a catalog. A line that is none is counted, and the others are read: a car that is switched
/// off while it writes leaves such lines.
std::vector<TubRecord> parse_tub_catalog(std::string_view text, const std::string& name,
                                         const std::string& image_key, LeftOut& unreadable);

/// A record_N.json of a tub of version 2, with N as its index. Those of the first Donkeycars have no time.
/// @return nullopt: it names no image, or has not the time that is needed
std::optional<TubRecord> parse_old_tub_record(std::string_view text, std::int64_t index, bool needs_time);

/// Whether the folder holds a tub, of whatever version.
bool is_tub(const std::filesystem::path& folder);

Result<std::unique_ptr<ImageSequence>> open_tub(const std::filesystem::path& folder,
                                                const ImageSequenceOptions& options);

}  // namespace aisle
