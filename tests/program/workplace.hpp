#pragma once

#include <gmock/gmock.h>

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "run_aisle.hpp"

namespace aisle {

/// A fresh directory for one test, removed with all its content.
class TemporaryDirectory {
 public:
  TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  ~TemporaryDirectory();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::string read_bytes(const std::filesystem::path& path);
void write_bytes(const std::filesystem::path& path, std::string_view bytes);

/// Every file of a directory: its bytes, and when it was last written.
using FolderState = std::map<std::string, std::pair<std::string, std::filesystem::file_time_type>>;
FolderState state_of_folder(const std::filesystem::path& directory);

/// The names in a directory, sorted; none if there is no such directory.
std::vector<std::string> names_in(const std::filesystem::path& directory);

/// Tests that start the program, each in its own directory.
class Workplace : public testing::Test {
 protected:
  std::string at(const std::string& name) const { return (directory_.path() / name).string(); }

  /// Writes a file for the test; returns its path.
  std::string file(const std::string& name, std::string_view bytes) const;

 private:
  TemporaryDirectory directory_;
};

/// A workplace with a log that the simulator records on the spot.
class WorkplaceWithLog : public Workplace {
 protected:
  void SetUp() override;

  std::string log() const { return at("sim/simulated-trip.log"); }
  std::string relations() const { return at("sim/true.relations"); }

  /// The recorded log's lines, comments first.
  std::vector<std::string> log_lines() const;

  /// Writes a copy of the log with other lines; returns its path.
  std::string log_of(const std::string& name, const std::vector<std::string>& lines) const;
};

/// The line with its `index`-th field (from 0) replaced.
std::string with_field(const std::string& line, std::size_t index, const std::string& value);

/// The line numbers of the scans.
std::vector<std::size_t> scan_lines(const std::vector<std::string>& lines);

/// Bad usage or bad input: exit code 2, one line that contains `what`, and no result.
MATCHER_P(IsRefused, what, std::string("is refused with one line that says '") + what + "'") {
  *result_listener << "exit code " << arg.exit_code << ", stderr: " << arg.err << "stdout: " << arg.out;
  if (arg.exit_code != 2 || arg.err.find(what) == std::string::npos) return false;
  if (arg.err.find('\n') != arg.err.size() - 1) return false;
  const nlohmann::json result = nlohmann::json::parse(arg.out, nullptr, false);
  return result.is_object() && result["ok"] == false && result["files"].empty() &&
         result["figures"].empty() && !result["problems"].empty();
}

}  // namespace aisle
