#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "aisle/formats/sessions/session_cycles.hpp"
#include "aisle/formats/sessions/session_summary.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

namespace {

/// A session whose file is the fuzzer's input; in a memory file system if there is one.
std::filesystem::path make_session(const std::string& storage, const std::string& file) {
  const std::filesystem::path memory = "/dev/shm";
  std::error_code error;
  const auto base =
      std::filesystem::is_directory(memory, error) ? memory : std::filesystem::temp_directory_path();
  const auto directory = base / ("aisle-fuzz-session-" + storage + std::to_string(::getpid()));
  std::filesystem::create_directories(directory);
  std::ofstream(directory / "metadata.yaml")
      << "rosbag2_bagfile_information:\n  storage_identifier: " << storage << "\n  relative_file_paths: ["
      << file << "]\n";
  return directory;
}

void read_to_the_end(const std::filesystem::path& directory) {
  auto cycles = SessionCycles::open(directory);
  while (cycles.ok()) {
    const auto cycle = cycles->next();
    if (!cycle || !cycle->has_value()) return;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const auto database = make_session("sqlite3", "fuzz_0.db3"),
                    mcap = make_session("mcap", "fuzz_0.mcap");
  const std::string_view text = fuzz_text(bytes, size);
  const bool is_mcap = text.starts_with("\x89MCAP");
  const std::filesystem::path& directory = is_mcap ? mcap : database;
  std::ofstream(directory / (is_mcap ? "fuzz_0.mcap" : "fuzz_0.db3"), std::ios::binary) << text;
  (void)summarise_session(directory);
  read_to_the_end(directory);
  return 0;
}
