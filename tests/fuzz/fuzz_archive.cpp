#include "aisle/formats/archive.hpp"
#include "fuzz_file.hpp"

using namespace aisle;

/// What was unpacked is there, and nothing but files and folders.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::filesystem::path file = fuzz_file(".tar.xz", bytes, size);
  is_archive(file);
  SilentProgress silent;
  const auto unpacked = UnpackedArchive::open(file, silent);
  if (!unpacked) {
    require(!unpacked.problems().empty());
    return 0;
  }
  require(std::filesystem::exists(unpacked->root()));
  if (!std::filesystem::is_directory(unpacked->root())) return 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(unpacked->root()))
    require(!entry.is_symlink() && (entry.is_directory() || entry.is_regular_file()));
  return 0;
}
