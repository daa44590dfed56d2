#pragma once
/// Recordings that came packed: tar (plain, gzip, bzip2, xz or zstd), zip and 7z archives.

#include <filesystem>
#include <memory>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"

namespace aisle {

class UnpackingDirectory;

/// Whether a file is such an archive: by its content, a tar in xz or zstd by its name.
bool is_archive(const std::filesystem::path& file);

/// The files of an archive, in a folder of their own that goes with this object.
class UnpackedArchive {
 public:
  /// Unpacks regular files; links and devices are left out with a warning. Of a damaged archive, what comes
  /// before is there, with a warning.
  /// Problems: nothing can be unpacked; a name leads out of the archive; more than 10,000 files; absurdly
  /// more bytes than the archive has; a password is needed.
  static Result<UnpackedArchive> open(const std::filesystem::path& archive, Progress& progress);

  UnpackedArchive(UnpackedArchive&&) noexcept;
  UnpackedArchive& operator=(UnpackedArchive&&) noexcept;
  ~UnpackedArchive();

  /// What it holds: a folder named as the archive, or the one file or folder that everything else is in.
  const std::filesystem::path& root() const { return root_; }
  /// A text with each unpacked file named by the archive and its place in it.
  std::string renamed(std::string text) const;
  const Problems& warnings() const { return warnings_; }

 private:
  UnpackedArchive(std::filesystem::path archive, UnpackingDirectory directory);

  std::filesystem::path archive_;
  std::unique_ptr<UnpackingDirectory> directory_;
  std::filesystem::path folder_, root_;
  Problems warnings_;
};

}  // namespace aisle
