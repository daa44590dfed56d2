#pragma once
/// The files of a session and the SQL of rosbag2's layout.

#include <filesystem>

#include "aisle/core/result.hpp"
#include "sessions/session_metadata.hpp"
#include "sessions/sqlite.hpp"

namespace aisle {

inline constexpr const char* kMetadataName = "metadata.yaml";
inline constexpr std::size_t kMetadataMax_bytes = std::size_t{16} << 20;

/// DIRECTORY/NAME_0.db3 or .mcap, where NAME is the directory's own name.
std::filesystem::path storage_path(const std::filesystem::path& directory, SessionStorage storage);

/// Prepares a new session: creates the directory and, with `force`, removes the session in it.
Problems prepare_directory(const std::filesystem::path& directory, bool force);

/// Removes a session's files, and the directory if nothing else is in it.
void remove_session(const std::filesystem::path& directory);

/// Merges the journal into the database, removes it and writes metadata.yaml: the session is then complete.
Problems finish_database(const std::filesystem::path& directory, const sqlite::Database& database);

/// The file of a session, by its metadata.yaml.
Result<SessionFile> find_session_file(const std::filesystem::path& directory);

/// Opens a session's database for reading. One that is cut off is a problem.
Result<sqlite::Database> open_database(const std::filesystem::path& path);

}  // namespace aisle
