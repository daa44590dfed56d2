#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "aisle/formats/json_document.hpp"
#include "field_reader.hpp"
#include "image_sequences/donkey_tub.hpp"
#include "image_sequences/stamp_order.hpp"

namespace aisle {
namespace {

constexpr std::size_t kFileNameBytesMax = 255;

/// The name of a file in a folder: manifests written elsewhere may hold that place's whole paths.
std::string file_name(const nlohmann::json& value) {
  if (!value.is_string()) return {};
  std::string name = std::filesystem::path(value.get<std::string>()).filename().string();
  return name.size() <= kFileNameBytesMax && name.find('\0') == std::string::npos ? name : std::string();
}

double number_or(const nlohmann::json& record, const char* key, double otherwise) {
  const auto found = record.find(key);
  return found != record.end() && found->is_number() ? found->get<double>() : otherwise;
}

/// The text's value; null if it is no JSON.
nlohmann::json parsed(std::string_view text) {
  auto value = parse_json(text, "");
  return value ? std::move(*value) : nlohmann::json();
}

/// What records of all versions hold. @return nullopt without an image's name
std::optional<TubRecord> record_of(const nlohmann::json& json, std::int64_t index,
                                   const std::string& image_key) {
  TubRecord record{.index = index, .image = file_name(json.value(image_key, nlohmann::json()))};
  if (record.image.empty()) return std::nullopt;
  if (json.contains("user/angle") || json.contains("user/throttle"))
    record.controls = {number_or(json, "user/angle", 0), number_or(json, "user/throttle", 0)};
  return record;
}

bool is_stamp(double stamp_s) {
  return stamp_s >= 0 && stamp_s <= kStampMax_s;
}

/// A line of a catalog.
std::optional<TubRecord> catalog_record(const nlohmann::json& json, const std::string& image_key) {
  if (!json.is_object()) return std::nullopt;
  const nlohmann::json index = json.value("_index", nlohmann::json());
  if (!index.is_number_integer() || index.get<std::int64_t>() < 0) return std::nullopt;
  auto record = record_of(json, index.get<std::int64_t>(), image_key);
  if (!record) return std::nullopt;
  record->stamp_s = number_or(json, "_timestamp_ms", -1) / 1000;
  return is_stamp(record->stamp_s) ? record : std::nullopt;
}

/// The keys of a record that name images, by the manifest's first two lines.
std::vector<std::string> image_keys_of(const nlohmann::json& inputs, const nlohmann::json& types) {
  std::vector<std::string> keys;
  for (std::size_t i = 0; inputs.is_array() && types.is_array() && i < std::min(inputs.size(), types.size());
       ++i) {
    if (types[i] == "image_array" && inputs[i].is_string()) keys.push_back(inputs[i].get<std::string>());
  }
  return keys;
}

void take_catalogs(const nlohmann::json& line, TubManifest& manifest) {
  for (const nlohmann::json& path : line["paths"]) {
    if (std::string name = file_name(path); !name.empty()) manifest.catalogs.push_back(std::move(name));
  }
  const auto deleted = line.find("deleted_indexes");
  if (deleted == line.end() || !deleted->is_array()) return;
  for (const nlohmann::json& index : *deleted) {
    if (index.is_number_integer()) manifest.deleted_indexes.insert(index.get<std::int64_t>());
  }
}

}  // namespace

Result<TubManifest> parse_tub_manifest(std::string_view text, const std::string& name) {
  TubManifest manifest;
  const nlohmann::json inputs = parsed(take_line(text)), types = parsed(take_line(text));
  if (auto keys = image_keys_of(inputs, types); !keys.empty()) manifest.image_keys = std::move(keys);
  while (!text.empty()) {
    const nlohmann::json line = parsed(take_line(text));
    if (line.is_object() && line.contains("paths") && line["paths"].is_array()) take_catalogs(line, manifest);
  }
  if (manifest.catalogs.empty())
    return Problem{{name, 0, "paths"}, "names no catalog: this is not the manifest of a tub"};
  return manifest;
}

std::vector<TubRecord> parse_tub_catalog(std::string_view text, const std::string& name,
                                         const std::string& image_key, LeftOut& unreadable) {
  std::vector<TubRecord> records;
  for (long number = 1; !text.empty(); ++number) {
    const std::string_view line = take_line(text);
    if (line.empty()) continue;
    if (auto record = catalog_record(parsed(line), image_key)) {
      records.push_back(std::move(*record));
    } else {
      unreadable.add(
          {{name, number},
           line.front() == '\0' ? "is a line of NUL bytes" : "is no record with index, time and image"});
    }
  }
  return records;
}

std::optional<TubRecord> parse_old_tub_record(std::string_view text, std::int64_t index, bool needs_time) {
  const nlohmann::json json = parsed(text);
  if (!json.is_object()) return std::nullopt;
  auto record = record_of(json, index, "cam/image_array");
  if (!record) return std::nullopt;
  record->stamp_s = number_or(json, "milliseconds", -1) / 1000;
  return !needs_time || is_stamp(record->stamp_s) ? record : std::nullopt;
}

}  // namespace aisle
