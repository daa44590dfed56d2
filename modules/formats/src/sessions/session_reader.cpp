#include "aisle/formats/sessions/session_reader.hpp"

#include <utility>

#include "sessions/session_files.hpp"
#include "sessions/session_source.hpp"

namespace aisle {
namespace fs = std::filesystem;

Result<std::unique_ptr<SessionSource>> open_session_source(const fs::path& directory) {
  const auto file = find_session_file(directory);
  if (!file) return file.problems();
  const fs::path path = directory / file->name;
  return file->storage == SessionStorage::kMcap ? open_mcap_session(path) : open_sqlite_session(path);
}

SessionReader::SessionReader(std::unique_ptr<SessionSource> source) : source_(std::move(source)) {}
SessionReader::SessionReader(SessionReader&&) noexcept = default;
SessionReader& SessionReader::operator=(SessionReader&&) noexcept = default;
SessionReader::~SessionReader() = default;

Result<SessionReader> SessionReader::open(const fs::path& directory) {
  auto source = open_session_source(directory);
  if (!source) return source.problems();
  return SessionReader(std::move(*source));
}

const std::vector<SessionTopic>& SessionReader::topics() const {
  return source_->topics();
}

const fs::path& SessionReader::database() const {
  return source_->path();
}

Result<std::optional<SessionReader::Message>> SessionReader::next() {
  return source_->next();
}

Result<std::optional<std::string>> SessionReader::first_of(const std::string& topic) const {
  return source_->first_of(topic);
}

}  // namespace aisle
