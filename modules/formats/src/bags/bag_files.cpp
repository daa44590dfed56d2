#include "bags/bag_files.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <optional>

#include "aisle/formats/whole_file.hpp"
#include "natural_order.hpp"
#include "sessions/session_files.hpp"
#include "yaml_text.hpp"

namespace aisle {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kFilesMax = 100'000;

struct BagMetadata {
  std::string compression;
  std::vector<std::string> files;
};

/// What metadata.yaml of any version says of the files. The rest is in the files themselves.
Result<BagMetadata> parse_metadata(const std::string& text, const std::string& name) try {
  const YAML::Node root = load_yaml(text);
  const YAML::Node bag = root.IsMap() ? root["rosbag2_bagfile_information"] : YAML::Node();
  if (!bag || !bag.IsMap())
    return Problem{{name, 0, "rosbag2_bagfile_information"}, "is missing: this is not a bag's metadata"};
  BagMetadata metadata;
  if (const YAML::Node format = bag["compression_format"]; format && format.IsScalar())
    metadata.compression = format.Scalar();
  const YAML::Node files = bag["relative_file_paths"];
  for (std::size_t i = 0; files && files.IsSequence() && i < std::min(files.size(), kFilesMax); ++i) {
    if (files[i].IsScalar()) metadata.files.push_back(files[i].Scalar());
  }
  return metadata;
} catch (const YAML::Exception& error) {
  return Problem{{name, error.mark.line + 1}, "is not YAML: " + error.msg};
}

/// The listed file: in the folder whatever the list says, so that no other place is read. Some bags list a
/// packed file by its name before it was packed, or the other way round.
std::optional<fs::path> listed_file(const fs::path& folder, const std::string& listed) {
  std::error_code error;
  const fs::path path = folder / fs::path(listed).filename();
  const fs::path packed = path.string() + ".zstd";
  for (const fs::path& candidate :
       {path, packed, path.extension() == ".zstd" ? fs::path(path).replace_extension() : path}) {
    if (candidate.has_filename() && fs::is_regular_file(candidate, error)) return candidate;
  }
  return std::nullopt;
}

Result<std::vector<fs::path>> bag_files_in(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code no_file;
    if (has_bag_name(entry->path()) && entry->is_regular_file(no_file)) files.push_back(entry->path());
  }
  if (error) return Problem{{folder.string()}, "cannot be read: " + error.message()};
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return is_before_naturally(a.filename().string(), b.filename().string());
  });
  // A file that lies there packed and unpacked is one.
  std::erase_if(files, [&](const fs::path& file) {
    return file.extension() == ".zstd" &&
           std::count(files.begin(), files.end(), fs::path(file).replace_extension()) > 0;
  });
  return files;
}

/// Takes the listed files that are there; says what is missing and what is not listed.
Problems take_listed(const BagMetadata& metadata, const fs::path& folder, BagFiles& bag) {
  const std::string name = (folder / kMetadataName).string();
  if (!metadata.compression.empty() && metadata.compression != "zstd")
    return {
        {{name, 0, "compression_format"}, fmt::format("'{}' is not read, only zstd", metadata.compression)}};
  for (const std::string& listed : metadata.files) {
    const auto file = listed_file(folder, listed);
    if (!file) {
      bag.warnings.push_back({{name, 0, "relative_file_paths"}, fmt::format("'{}' is missing", listed)});
    } else if (std::count(bag.paths.begin(), bag.paths.end(), *file) == 0) {
      bag.paths.push_back(*file);
    }
  }
  return {};
}

}  // namespace

bool has_bag_name(const fs::path& path) {
  const fs::path name = path.extension() == ".zstd" ? path.stem() : path.filename();
  const fs::path ending = name.extension();
  return ending == ".db3" || ending == ".mcap" || ending == ".bag" || name.string().ends_with(".bag.active");
}

Result<BagFiles> bag_files(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) return Problem{{path.string()}, "no such bag"};
  if (!fs::is_directory(path, error)) return BagFiles{.paths = {path}};
  const auto all = bag_files_in(path);
  if (!all) return all.problems();
  BagFiles bag;
  const fs::path name = path / kMetadataName;
  if (fs::exists(name, error)) {
    const auto text = read_whole_file(name, kMetadataMax_bytes);
    auto metadata = text ? parse_metadata(*text, name.string()) : Result<BagMetadata>(text.problems());
    if (metadata) {
      if (Problems problems = take_listed(*metadata, path, bag); !problems.empty()) return problems;
    } else {
      bag.warnings = metadata.problems();
    }
  } else {
    bag.warnings.push_back({{path.string()}, "has no metadata.yaml; the files that are there are read"});
  }
  bag.in_recorded_order = !bag.paths.empty();
  if (bag.paths.empty()) bag.paths = *all;
  if (bag.paths.empty())
    return Problem{{path.string()}, "holds no bag: no file in it ends in .db3, .mcap or .bag"};
  for (const fs::path& file : *all) {
    if (std::count(bag.paths.begin(), bag.paths.end(), file) == 0)
      bag.warnings.push_back({{file.string()}, "is left out: metadata.yaml does not list it"});
  }
  return bag;
}

}  // namespace aisle
