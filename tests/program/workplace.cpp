#include "workplace.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace aisle {
namespace fs = std::filesystem;

TemporaryDirectory::TemporaryDirectory() {
  std::string name = (fs::temp_directory_path() / "aisle-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary directory");
  path_ = name;
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string read_bytes(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_bytes(const fs::path& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

std::vector<std::string> names_in(const fs::path& directory) {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(directory, none)) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

FolderState state_of_folder(const fs::path& directory) {
  FolderState state;
  for (const auto& entry : fs::directory_iterator(directory))
    state[entry.path().filename().string()] = {read_bytes(entry.path()), entry.last_write_time()};
  return state;
}

std::string Workplace::file(const std::string& name, std::string_view bytes) const {
  write_bytes(at(name), bytes);
  return at(name);
}

void WorkplaceWithLog::SetUp() {
  const ProgramRun recording = run_aisle(
      {"sim", "log", AISLE_SOURCE_DIR "/worlds/small-office.yaml", "--seed", "1", "--out", at("sim")});
  ASSERT_EQ(recording.exit_code, 0) << recording.err;
}

std::vector<std::string> WorkplaceWithLog::log_lines() const {
  std::istringstream text(read_bytes(log()));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

std::string WorkplaceWithLog::log_of(const std::string& name, const std::vector<std::string>& lines) const {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return file(name, text);
}

std::string with_field(const std::string& line, std::size_t index, const std::string& value) {
  std::size_t start = 0;
  for (; index > 0; --index) start = line.find(' ', start) + 1;
  return line.substr(0, start) + value + line.substr(std::min(line.find(' ', start), line.size()));
}

std::vector<std::size_t> scan_lines(const std::vector<std::string>& lines) {
  std::vector<std::size_t> scans;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].starts_with("FLASER")) scans.push_back(i);
  }
  return scans;
}

}  // namespace aisle
