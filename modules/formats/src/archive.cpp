#include "aisle/formats/archive.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <fstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "aisle/formats/file_contents.hpp"
#include "file_limits.hpp"
#include "input_file.hpp"
#include "unpacked_file.hpp"
#include "unpacking_directory.hpp"

namespace aisle {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kArchiveBlock_bytes = std::size_t{1} << 20;
constexpr std::size_t kArchiveFilesMax = 10'000;
constexpr std::size_t kArchiveHead_bytes = 512;  ///< a tar's first header

struct EndArchive {
  void operator()(::archive* archive) const { archive_read_free(archive); }
};
using OpenArchive = std::unique_ptr<::archive, EndArchive>;

/// Only formats that the library reads by itself: for others it would run programs.
OpenArchive opened_archive() {
  OpenArchive archive(archive_read_new());
  archive_read_support_filter_gzip(archive.get());
  archive_read_support_filter_bzip2(archive.get());
  archive_read_support_filter_xz(archive.get());
  archive_read_support_filter_zstd(archive.get());
  archive_read_support_format_tar(archive.get());
  archive_read_support_format_zip(archive.get());
  archive_read_support_format_7zip(archive.get());
  return archive;
}

std::string why_of(::archive* archive) {
  const char* const why = archive_error_string(archive);
  return why != nullptr ? why : "unknown damage";
}

/// The place of an entry below the folder; nullopt if its name leads elsewhere.
std::optional<fs::path> place_in(const fs::path& folder, const char* name) {
  if (name == nullptr || *name == '\0') return std::nullopt;
  const fs::path place = fs::path(name).lexically_normal();
  if (place.is_absolute() || place.empty() || *place.begin() == "..") return std::nullopt;
  return folder / place;
}

/// Unpacks one archive into a folder.
class ArchiveUnpacking {
 public:
  ArchiveUnpacking(const fs::path& file, const fs::path& folder, Progress& progress)
      : file_(file), folder_(folder), progress_(progress), packed_bytes_(fs::file_size(file)) {}

  /// @return problems: it cannot be used
  Problems run() {
    archive_ = opened_archive();
    if (archive_read_open_filename(archive_.get(), file_.c_str(), kArchiveBlock_bytes) != ARCHIVE_OK)
      return problem(fmt::format("cannot be unpacked: {}", why_of(archive_.get())));
    archive_entry* entry = nullptr;
    for (;;) {
      const int status = archive_read_next_header(archive_.get(), &entry);
      if (status == ARCHIVE_EOF) break;
      if (status != ARCHIVE_OK && status != ARCHIVE_WARN) return damaged();
      if (Problems problems = take(entry); !problems.empty()) return problems;
      if (is_damaged_) return damaged();
    }
    return files_ > 0 ? Problems() : problem("holds no files");
  }

  Problems warnings;

 private:
  Problems problem(std::string what) const { return {{{file_.string()}, std::move(what)}}; }

  /// What came before is used, if there is anything.
  Problems damaged() {
    const std::string why = why_of(archive_.get());
    if (files_ == 0) return problem("cannot be unpacked: " + why);
    warnings.push_back({{file_.string()}, fmt::format("is damaged ({}); what comes before is used", why)});
    return {};
  }

  Problems take(archive_entry* entry) {
    const char* const name = archive_entry_pathname(entry);
    if (archive_entry_filetype(entry) == AE_IFDIR) return {};
    const auto place = place_in(folder_, name);
    if (!place)
      return problem(
          fmt::format("holds a file named '{}', which leads out of it", name != nullptr ? name : ""));
    if (archive_entry_is_encrypted(entry) != 0) return problem("needs a password; unpack it first");
    if (archive_entry_filetype(entry) != AE_IFREG || archive_entry_hardlink(entry) != nullptr) {
      warnings.push_back({{file_.string()}, fmt::format("'{}' is no regular file and left out", name)});
      return {};
    }
    if (++files_ > kArchiveFilesMax)
      return problem(
          fmt::format("holds more than {} files; unpack it, and name the recording", kArchiveFilesMax));
    return write(*place);
  }

  Problems write(const fs::path& place) {
    std::error_code error;
    fs::create_directories(place.parent_path(), error);
    std::ofstream out(place, std::ios::binary);
    block_.resize(kArchiveBlock_bytes);
    for (;;) {
      const la_ssize_t bytes = archive_read_data(archive_.get(), block_.data(), block_.size());
      if (bytes < 0) is_damaged_ = true;
      if (bytes <= 0) break;
      unpacked_bytes_ += static_cast<std::uint64_t>(bytes);
      if (unpacked_bytes_ > kUnpackedFreely_bytes && unpacked_bytes_ / kUnpackedRatioMax > packed_bytes_)
        return problem(fmt::format("unpacks to more than {} times its size", kUnpackedRatioMax));
      if (!out.write(block_.data(), bytes))
        return problem(fmt::format("{} cannot be written: is the disk full?", place.string()));
      progress_.report("unpacking", static_cast<std::size_t>(archive_filter_bytes(archive_.get(), -1)),
                       packed_bytes_);
    }
    out.close();
    return out ? Problems() : problem(fmt::format("{} cannot be written: is the disk full?", place.string()));
  }

  fs::path file_, folder_;
  Progress& progress_;
  std::uint64_t packed_bytes_;
  OpenArchive archive_;
  std::vector<char> block_;
  std::size_t files_ = 0;
  std::uint64_t unpacked_bytes_ = 0;
  bool is_damaged_ = false;
};

/// Down to what is not alone in its folder.
fs::path innermost(fs::path place) {
  for (;;) {
    std::vector<fs::path> entries;
    std::error_code error;
    for (fs::directory_iterator entry(place, error), end; !error && entry != end && entries.size() < 2;
         entry.increment(error))
      entries.push_back(entry->path());
    if (entries.size() != 1) return place;
    place = entries.front();
  }
}

fs::path name_without_endings(const fs::path& archive) {
  const fs::path name = archive.stem();
  return name.extension() == ".tar" ? name.stem() : name;
}

}  // namespace

bool is_archive(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return false;
  const auto head = read_unpacked_head(file, kArchiveHead_bytes);
  if (!head) return false;
  if (head->starts_with("PK\x03\x04") || head->starts_with("7z\xbc\xaf\x27\x1c") || is_tar_archive(*head))
    return true;
  const std::string name = file.filename().string();
  const auto is_named = [&](const char* ending) { return name.ends_with(ending); };
  return is_named(".tar.xz") || is_named(".txz") || is_named(".tar.zst") || is_named(".tzst");
}

UnpackedArchive::UnpackedArchive(fs::path archive, UnpackingDirectory directory)
    : archive_(std::move(archive)),
      directory_(std::make_unique<UnpackingDirectory>(std::move(directory))),
      folder_(directory_->path() / name_without_endings(archive_)) {}
UnpackedArchive::UnpackedArchive(UnpackedArchive&&) noexcept = default;
UnpackedArchive& UnpackedArchive::operator=(UnpackedArchive&&) noexcept = default;
UnpackedArchive::~UnpackedArchive() = default;

Result<UnpackedArchive> UnpackedArchive::open(const fs::path& archive, Progress& progress) {
  auto directory = UnpackingDirectory::create();
  if (!directory) return directory.problems();
  UnpackedArchive unpacked(archive, std::move(*directory));
  ArchiveUnpacking unpacking(archive, unpacked.folder_, progress);
  if (Problems problems = unpacking.run(); !problems.empty()) return problems;
  unpacked.warnings_ = std::move(unpacking.warnings);
  unpacked.root_ = innermost(unpacked.folder_);
  return unpacked;
}

std::string UnpackedArchive::renamed(std::string text) const {
  const std::string from = folder_.string(), to = archive_.string();
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

}  // namespace aisle
