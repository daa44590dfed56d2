#include "sessions/sqlite.hpp"

#include <fmt/format.h>

#include <cctype>

namespace aisle::sqlite {
namespace {

/// The largest message of a session: a colour image of 8192 x 8192 pixels fits.
constexpr int kValueMax_bytes = 256 << 20;

/// An absolute path, because SQLite treats names that begin with "file:" as URIs.
std::string absolute_name(const std::filesystem::path& path) {
  return std::filesystem::absolute(path).string();
}

}  // namespace

Result<Database> Database::open(const std::filesystem::path& path, const std::string& name, int flags,
                                const char* setup) {
  Database database;
  database.path_ = path;
  sqlite3* handle = nullptr;
  const int code = sqlite3_open_v2(name.c_str(), &handle, flags, nullptr);
  database.handle_.reset(handle);
  if (code != SQLITE_OK) return database.failure("cannot be opened");
  sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, kValueMax_bytes);
  if ((flags & SQLITE_OPEN_READWRITE) != 0) sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  if (sqlite3_exec(handle, setup, nullptr, nullptr, nullptr) != SQLITE_OK)
    return database.failure("cannot be opened");
  return database;
}

Result<Database> Database::create(const std::filesystem::path& path) {
  return open(path, absolute_name(path), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE,
              "PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL");
}

Result<Database> Database::open(const std::filesystem::path& path) {
  return open(path, absolute_name(path), SQLITE_OPEN_READWRITE,
              "PRAGMA trusted_schema = OFF; PRAGMA cell_size_check = ON");
}

Result<Database> Database::open_unchanged(const std::filesystem::path& path) {
  std::string uri = "file:";
  for (const char c : absolute_name(path)) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '/';
    uri += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  // A file that is shorter than its header says is refused unless the schema may be written, as for repair.
  return open(path, uri + "?immutable=1", SQLITE_OPEN_READONLY | SQLITE_OPEN_URI,
              "PRAGMA trusted_schema = OFF; PRAGMA cell_size_check = ON; PRAGMA writable_schema = ON");
}

Problems Database::run(const char* sql) const {
  if (sqlite3_exec(handle_.get(), sql, nullptr, nullptr, nullptr) == SQLITE_OK) return {};
  return {failure("cannot be written")};
}

Result<Statement> Database::prepare(const char* sql) const {
  sqlite3_stmt* handle = nullptr;
  if (sqlite3_prepare_v2(handle_.get(), sql, -1, &handle, nullptr) != SQLITE_OK)
    return failure("is not a session database");
  return Statement(*this, handle);
}

Problem Database::failure(const char* what) const {
  return {{path_.string()}, fmt::format("{}: {}", what, sqlite3_errmsg(handle_.get()))};
}

void Statement::bind(int parameter, std::int64_t value) {
  sqlite3_bind_int64(handle_.get(), parameter + 1, value);
}

void Statement::bind_text(int parameter, std::string_view text) {
  sqlite3_bind_text(handle_.get(), parameter + 1, text.data(), static_cast<int>(text.size()), SQLITE_STATIC);
}

void Statement::bind_blob(int parameter, std::string_view bytes) {
  sqlite3_bind_blob(handle_.get(), parameter + 1, bytes.data(), static_cast<int>(bytes.size()),
                    SQLITE_STATIC);
}

Problems Statement::run() {
  const bool done = sqlite3_step(handle_.get()) == SQLITE_DONE;
  Problems problems;
  if (!done) problems.push_back(database_->failure("cannot be written"));
  sqlite3_reset(handle_.get());
  return problems;
}

Result<bool> Statement::step() {
  switch (sqlite3_step(handle_.get())) {
    case SQLITE_ROW:
      return true;
    case SQLITE_DONE:
      return false;
    default:
      return database_->failure("cannot be read");
  }
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(handle_.get(), column);
}

std::string_view Statement::bytes(int column) const {
  const auto* data = static_cast<const char*>(sqlite3_column_blob(handle_.get(), column));
  return {data, data == nullptr ? 0 : static_cast<std::size_t>(sqlite3_column_bytes(handle_.get(), column))};
}

}  // namespace aisle::sqlite
