#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_reader.hpp"

namespace aisle {

/// The file of a session while it is read.
class SessionSource {
 public:
  /// A message without its bytes.
  struct Row {
    std::size_t topic = 0;  ///< index in topics()
    ros::Stamp_ns stamp = 0;
    std::int64_t bytes = 0;
  };

  virtual ~SessionSource() = default;

  /// These are what SessionReader promises.
  virtual const std::vector<SessionTopic>& topics() const = 0;
  virtual Result<std::optional<SessionReader::Message>> next() = 0;
  virtual Result<std::optional<std::string>> first_of(const std::string& topic) const = 0;

  /// The next message of a walk of its own over all messages, in the order of next().
  virtual Result<std::optional<Row>> next_row() = 0;

  const std::filesystem::path& path() const { return path_; }

 protected:
  explicit SessionSource(std::filesystem::path path) : path_(std::move(path)) {}

 private:
  std::filesystem::path path_;
};

/// Opens a session by its metadata.yaml, whatever its storage.
Result<std::unique_ptr<SessionSource>> open_session_source(const std::filesystem::path& directory);

Result<std::unique_ptr<SessionSource>> open_sqlite_session(const std::filesystem::path& path);
Result<std::unique_ptr<SessionSource>> open_mcap_session(const std::filesystem::path& path);

}  // namespace aisle
