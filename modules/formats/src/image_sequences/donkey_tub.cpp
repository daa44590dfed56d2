#include "image_sequences/donkey_tub.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "aisle/core/median.hpp"
#include "aisle/formats/whole_file.hpp"
#include "field_reader.hpp"
#include "image_sequences/image_list.hpp"
#include "image_sequences/stamp_order.hpp"
#include "natural_order.hpp"

namespace aisle {
namespace fs = std::filesystem;

namespace {

constexpr const char* kManifest = "manifest.json";
constexpr std::size_t kTextBytesMax = std::size_t{256} << 20;
constexpr double kFastestCamera_hz = 120;
constexpr double kIndexMax = 1e9;

bool is_catalog(const fs::path& file) {
  return file.filename().string().starts_with("catalog_") && file.extension() == ".catalog";
}

bool is_old_record(const fs::path& file) {
  return file.filename().string().starts_with("record_") && file.extension() == ".json";
}

/// Without a manifest that can be read, all catalogs of the folder are.
Result<TubManifest> manifest_of(const fs::path& folder, Problems& warnings) {
  const fs::path file = folder / kManifest;
  const auto text = read_whole_file(file, kTextBytesMax);
  auto manifest = text ? parse_tub_manifest(*text, file.string()) : Result<TubManifest>(text.problems());
  if (manifest) return manifest;
  TubManifest found;
  for (const fs::path& catalog : files_in_natural_order(folder, is_catalog))
    found.catalogs.push_back(catalog.filename().string());
  if (found.catalogs.empty()) return manifest.problems();
  const Problem& why = manifest.problems().front();
  warnings.push_back({why.where, why.what + "; all catalogs of the folder are read, deleted records too"});
  return found;
}

std::vector<TubRecord> read_catalogs(const fs::path& folder, const TubManifest& manifest, ImageList& list) {
  std::vector<TubRecord> records;
  LeftOut missing;
  for (const std::string& name : manifest.catalogs) {
    const fs::path file = folder / name;
    const auto text = read_whole_file(file, kTextBytesMax);
    if (!text) {
      missing.add(text.problems().front());
      continue;
    }
    auto of_catalog = parse_tub_catalog(*text, file.string(), manifest.image_keys.front(), list.unreadable);
    std::move(of_catalog.begin(), of_catalog.end(), std::back_inserter(records));
  }
  missing.warn("catalog", list.warnings);
  return records;
}

/// A tub of version 2 has one file a record.
std::vector<TubRecord> read_old_records(const std::vector<fs::path>& files, bool needs_time,
                                        LeftOut& unreadable) {
  std::vector<TubRecord> records;
  for (const fs::path& file : files) {
    const std::string name = file.stem().string();
    const auto index = parse_number(std::string_view(name).substr(name.find('_') + 1));
    const auto text = read_whole_file(file, kTextBytesMax);
    auto record = index && text && std::abs(*index) < kIndexMax
                      ? parse_old_tub_record(*text, static_cast<std::int64_t>(*index), needs_time)
                      : std::nullopt;
    if (record) {
      records.push_back(std::move(*record));
    } else {
      unreadable.add({{file.string()}, "is no record with image and milliseconds (or use --image-rate HZ)"});
    }
  }
  return records;
}

/// In the order of their indexes, without those that the driver deleted. Of records with the same index the
/// last is right: the car overwrote the image.
void keep_valid(std::vector<TubRecord>& records, const std::set<std::int64_t>& deleted) {
  std::erase_if(records, [&](const TubRecord& record) { return deleted.contains(record.index); });
  std::reverse(records.begin(), records.end());
  std::stable_sort(records.begin(), records.end(),
                   [](const TubRecord& a, const TubRecord& b) { return a.index < b.index; });
  const auto same = [](const TubRecord& a, const TubRecord& b) { return a.index == b.index; };
  records.erase(std::unique(records.begin(), records.end(), same), records.end());
}

/// Times of a conversion are no times of a camera.
void warn_of_conversion(ImageList& list) {
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < list.images.size(); ++i)
    steps_s.push_back(list.images[i].stamp_s - list.images[i - 1].stamp_s);
  if (steps_s.empty()) return;
  const double step_s = median(std::move(steps_s));
  if (step_s * kFastestCamera_hz >= 1) return;
  list.warnings.push_back(
      {{list.recording.string()},
       fmt::format(
           "has stamps {:.1f} ms apart, faster than a camera: they may be of a conversion; --image-rate HZ "
           "gives the images' rate",
           1000 * step_s)});
}

Result<std::unique_ptr<ImageSequence>> sequence_of(std::vector<TubRecord> records, const fs::path& images,
                                                   ImageList list, const ImageSequenceOptions& options) {
  for (TubRecord& record : records) {
    if (options.rate_hz)
      record.stamp_s = static_cast<double>(record.index - records.front().index) / *options.rate_hz;
    list.images.push_back({record.stamp_s, images / record.image, {}, record.controls});
  }
  if (Problems problems = order_stamps(list); !problems.empty()) return problems;
  if (!options.rate_hz) warn_of_conversion(list);
  list.warnings.push_back({{list.recording.string()},
                           "has no odometry (throttle is not a speed): nothing that needs it, such as "
                           "aisle learn, works with this recording"});
  return sequence_of(std::move(list));
}

}  // namespace

bool is_tub(const fs::path& folder) {
  std::error_code error;
  return fs::exists(folder / kManifest, error) || !files_in_natural_order(folder, is_catalog).empty() ||
         !files_in_natural_order(folder, is_old_record).empty();
}

Result<std::unique_ptr<ImageSequence>> open_tub(const fs::path& folder, const ImageSequenceOptions& options) {
  std::error_code error;
  ImageList list{.recording = folder, .images = {}, .unreadable = {}, .warnings = {}};
  const auto old_records = files_in_natural_order(folder, is_old_record);
  if (!fs::exists(folder / kManifest, error) && !old_records.empty()) {
    std::vector<TubRecord> records = read_old_records(old_records, !options.rate_hz, list.unreadable);
    return sequence_of(std::move(records), folder, std::move(list), options);
  }
  const auto manifest = manifest_of(folder, list.warnings);
  if (!manifest) return manifest.problems();
  if (manifest->image_keys.size() > 1) {
    list.warnings.push_back({{(folder / kManifest).string()},
                             fmt::format("names images of {} cameras; only those of '{}' are read",
                                         manifest->image_keys.size(), manifest->image_keys.front())});
  }
  std::vector<TubRecord> records = read_catalogs(folder, *manifest, list);
  keep_valid(records, manifest->deleted_indexes);
  return sequence_of(std::move(records), folder / "images", std::move(list), options);
}

}  // namespace aisle
