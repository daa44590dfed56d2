#include "sessions/session_files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <vector>

#include "aisle/formats/sessions/session_writer.hpp"
#include "aisle/formats/whole_file.hpp"

namespace aisle {
namespace fs = std::filesystem;

namespace {

/// SQLite silently pads a truncated last page; here it is a problem.
Problems check_length(const sqlite::Database& database) {
  if (database.is_copy()) return {};  // the rest may be in the journal
  auto pages = database.prepare("SELECT page_count * page_size FROM pragma_page_count(), pragma_page_size()");
  if (!pages) return pages.problems();
  if (const Result<bool> row = pages->step(); !row) return row.problems();
  std::error_code error;
  const auto bytes = static_cast<std::int64_t>(fs::file_size(database.path(), error));
  if (bytes >= pages->integer(0)) return {};
  return {{{database.path().string()},
           fmt::format("is cut off: it has {} of {} bytes", bytes, pages->integer(0))}};
}

/// The files of a session, killed or not, and its picture.
bool belongs_to_session(const fs::path& file) {
  const std::string name = file.filename().string();
  return name == kDrivenImage || name == kMetadataName || name == std::string(kMetadataName) + ".part" ||
         name.ends_with(".mcap") || name.ends_with(".db3") || name.ends_with(".db3-wal") ||
         name.ends_with(".db3-shm") || name.ends_with(".db3-journal");
}

Result<std::vector<fs::path>> files_in(const fs::path& directory) {
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(directory, error), end; !error && entry != end; entry.increment(error))
    files.push_back(entry->path());
  if (error) return Problem{{directory.string()}, "cannot be read: " + error.message()};
  std::sort(files.begin(), files.end());
  return files;
}

Problems remove_files(const fs::path& directory, const std::vector<fs::path>& files) {
  for (const fs::path& file : files) {
    if (!belongs_to_session(file) || fs::is_directory(file))
      return {{{file.string()}, "is not part of a session, so " + directory.string() + " is not replaced"}};
  }
  for (const fs::path& file : files) {
    std::error_code error;
    fs::remove(file, error);
    if (error) return {{{file.string()}, "cannot be removed: " + error.message()}};
  }
  return {};
}

/// A summary of the database for metadata.yaml.
Result<SessionMetadata> metadata_of(const sqlite::Database& database) {
  SessionMetadata metadata;
  metadata.file_name = database.path().filename().string();
  auto topics = database.prepare(
      "SELECT name, type, offered_qos_profiles, count(messages.id), min(timestamp), max(timestamp) "
      "FROM topics LEFT JOIN messages ON topic_id = topics.id GROUP BY topics.id ORDER BY topics.id");
  if (!topics) return topics.problems();
  while (true) {
    const Result<bool> more = topics->step();
    if (!more) return more.problems();
    if (!*more) break;
    const std::int64_t messages = topics->integer(3);
    metadata.topics.push_back({{.name = std::string(topics->bytes(0)),
                                .type = std::string(topics->bytes(1)),
                                .latched = is_latched(std::string(topics->bytes(2)))},
                               messages});
    if (messages == 0) continue;
    const bool first = metadata.messages == 0;
    metadata.first = first ? topics->integer(4) : std::min(metadata.first, topics->integer(4));
    metadata.last = first ? topics->integer(5) : std::max(metadata.last, topics->integer(5));
    metadata.messages += messages;
  }
  return metadata;
}

}  // namespace

fs::path storage_path(const fs::path& directory, SessionStorage storage) {
  fs::path whole = fs::absolute(directory).lexically_normal();
  if (!whole.has_filename()) whole = whole.parent_path();
  const char* const ending = storage == SessionStorage::kMcap ? "_0.mcap" : "_0.db3";
  return directory / (whole.filename().string() + ending);
}

Problems prepare_directory(const fs::path& directory, bool force) {
  if (directory.empty()) return {{{"session"}, "names no directory"}};
  std::error_code error;
  fs::create_directories(directory, error);
  if (!fs::is_directory(directory)) {
    const std::string why =
        fs::exists(directory) ? "is not a directory" : "cannot be made: " + error.message();
    return {{{directory.string()}, why}};
  }
  if (::access(directory.c_str(), W_OK | X_OK) != 0) return {{{directory.string()}, "cannot be written to"}};
  const auto files = files_in(directory);
  if (!files) return files.problems();
  if (files->empty()) return {};
  if (!force) return {{{directory.string()}, "is not empty; --force replaces an existing session"}};
  return remove_files(directory, *files);
}

void remove_session(const fs::path& directory) {
  if (const auto files = files_in(directory)) (void)remove_files(directory, *files);
  std::error_code error;
  fs::remove(directory, error);
}

Problems finish_database(const fs::path& directory, const sqlite::Database& database) {
  const auto metadata = metadata_of(database);
  if (!metadata) return metadata.problems();
  const std::string yaml = metadata_yaml(*metadata);
  auto insert = database.prepare("INSERT OR REPLACE INTO metadata VALUES (1, 5, ?)");
  if (!insert) return insert.problems();
  insert->bind_text(0, yaml);
  if (Problems problems = insert->run(); !problems.empty()) return problems;
  if (Problems problems = database.run("PRAGMA journal_mode = DELETE"); !problems.empty()) return problems;
  return write_whole_file(directory / kMetadataName, yaml);
}

Result<SessionFile> find_session_file(const fs::path& directory) {
  const fs::path metadata = directory / kMetadataName;
  if (!fs::exists(directory)) return Problem{{directory.string()}, "no such session"};
  if (!fs::is_directory(directory))
    return Problem{{directory.string()},
                   "is a file; a session is a directory with metadata.yaml in it, and `aisle import` makes "
                   "one of a recording"};
  if (!fs::exists(metadata))
    return Problem{{directory.string()},
                   "has no metadata.yaml, so it is not a session; `aisle import` makes one of a recording"};
  const auto yaml = read_whole_file(metadata, kMetadataMax_bytes);
  if (!yaml) return yaml.problems();
  auto file = parse_session_file(*yaml, metadata.string());
  if (!file) return file;
  const fs::path path = directory / file->name;
  if (!fs::is_regular_file(path))
    return Problem{{path.string()}, "is missing, though metadata.yaml names it"};
  return file;
}

Result<sqlite::Database> open_database(const fs::path& path) {
  Result<sqlite::Database> database = sqlite::Database::open(path);
  if (!database) return database;
  if (Problems problems = check_length(*database); !problems.empty()) return problems;
  return database;
}

}  // namespace aisle
