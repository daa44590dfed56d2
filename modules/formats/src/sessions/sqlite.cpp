#include "sessions/sqlite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <utility>

namespace aisle::sqlite {
namespace fs = std::filesystem;

namespace {

/// The largest message of a session: a colour image of 8192 x 8192 pixels fits.
constexpr std::int64_t kValueMax_bytes = 256 << 20;

/// Steps of SQLite's machine that a statement may take: some for what every statement does, and for each byte
/// of the file more than twice what a walk over the rows of small messages takes, sorted.
constexpr std::int64_t kSteps = 5'000'000;
constexpr std::int64_t kStepsPerByte = 4;
constexpr int kStepsPerCheck = 1000;

constexpr std::array kJournalEndings{"-wal", "-journal"};
constexpr const char* kCopyName = "copy.db3";

/// An absolute path, because SQLite treats names that begin with "file:" as URIs.
std::string absolute_name(const fs::path& path) {
  return fs::absolute(path).string();
}

std::string immutable_uri(const fs::path& path) {
  std::string uri = "file:";
  for (const char c : absolute_name(path)) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '/';
    uri += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri + "?immutable=1";
}

std::int64_t size_or_zero(const fs::path& path) {
  std::error_code error;
  const auto bytes = fs::file_size(path, error);
  return error ? 0 : static_cast<std::int64_t>(bytes);
}

/// What a write-ahead log begins with: another one was begun if it changes.
std::string log_head(const fs::path& database) {
  std::string head(32, '\0');
  std::ifstream(database.string() + "-wal", std::ios::binary)
      .read(head.data(), static_cast<std::streamsize>(head.size()));
  return head;
}

std::error_code copy_files(const fs::path& database, const fs::path& to) {
  std::error_code error;
  fs::copy_file(database, to, fs::copy_options::overwrite_existing, error);
  for (const char* ending : kJournalEndings) {
    const std::string journal = database.string() + ending;
    if (!error && size_or_zero(journal) > 0)
      fs::copy_file(journal, to.string() + ending, fs::copy_options::overwrite_existing, error);
  }
  return error;
}

}  // namespace

Problems Database::open_handle(const std::string& name, int flags) {
  sqlite3* handle = nullptr;
  const int code = sqlite3_open_v2(name.c_str(), &handle, flags, nullptr);
  handle_.reset(handle);
  if (code != SQLITE_OK) return {failure("cannot be opened")};
  return {};
}

Result<Database> Database::create(const fs::path& path) {
  Database database;
  database.path_ = path;
  if (Problems problems =
          database.open_handle(absolute_name(path), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
      !problems.empty())
    return problems;
  sqlite3_limit(database.handle_.get(), SQLITE_LIMIT_LENGTH, static_cast<int>(kValueMax_bytes));
  if (Problems problems = database.run("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL");
      !problems.empty())
    return problems;
  return database;
}

Result<Database> Database::open(const fs::path& path) {
  Database database;
  database.path_ = path;
  if (Problems problems = database.copy_with_journals(); !problems.empty()) return problems;
  Problems problems = database.copy_
                          ? database.open_handle(database.copy_->path() / kCopyName, SQLITE_OPEN_READWRITE)
                          : database.open_handle(immutable_uri(path), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
  if (!problems.empty()) return problems;
  sqlite3_db_config(database.handle_.get(), SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  if (problems = database.read_only(""); !problems.empty()) return problems;
  return database;
}

Result<Database> Database::open_cut(const fs::path& path) {
  Database database;
  database.path_ = path;
  Problems problems = database.open_handle(immutable_uri(path), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
  if (!problems.empty()) return problems;
  // Such a file is refused unless the schema may be written, as for repair; nothing can be in a file that is
  // immutable.
  if (problems = database.read_only("; PRAGMA writable_schema = ON"); !problems.empty()) return problems;
  return database;
}

/// A log may be written meanwhile. What is copied is whole as long as no other log was begun, for everything
/// that goes from a log into the database is still in that log.
Problems Database::copy_with_journals() {
  const auto has_journal = [&](const char* ending) { return size_or_zero(path_.string() + ending) > 0; };
  constexpr int kTries = 5;
  for (int i = 0; i < kTries; ++i) {
    if (std::none_of(kJournalEndings.begin(), kJournalEndings.end(), has_journal)) {
      copy_.reset();
      return {};
    }
    auto directory = UnpackingDirectory::create();
    if (!directory) return directory.problems();
    copy_ = std::move(*directory);
    const std::string head = log_head(path_);
    const std::error_code error = copy_files(path_, copy_->path() / kCopyName);
    if (log_head(path_) != head) continue;
    if (error)
      return {{{path_.string()}, "needs a copy to be read, which cannot be made: " + error.message()}};
    return {};
  }
  return {{{path_.string()}, "is being written too fast to be read"}};
}

Problems Database::read_only(const char* setup) {
  effort_ = std::make_unique<Effort>();
  effort_->bytes = size_or_zero(path_);
  for (const char* ending : kJournalEndings) effort_->bytes += size_or_zero(path_.string() + ending);
  effort_->steps_left = kSteps;
  sqlite3* const handle = handle_.get();
  const auto count = [](void* effort) {
    return (static_cast<Effort*>(effort)->steps_left -= kStepsPerCheck) < 0 ? 1 : 0;
  };
  sqlite3_progress_handler(handle, kStepsPerCheck, count, effort_.get());
  sqlite3_limit(handle, SQLITE_LIMIT_LENGTH,
                static_cast<int>(std::min(kValueMax_bytes, effort_->bytes + 4096)));
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  const std::string pragmas = std::string("PRAGMA cell_size_check = ON; PRAGMA query_only = ON") + setup;
  if (sqlite3_exec(handle, pragmas.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
    return {failure("cannot be opened")};
  return {};
}

Problems Database::run(const char* sql) const {
  if (sqlite3_exec(handle_.get(), sql, nullptr, nullptr, nullptr) == SQLITE_OK) return {};
  return {failure("cannot be written")};
}

Result<Statement> Database::prepare(const char* sql) const {
  if (effort_)
    effort_->steps_left =
        std::max<std::int64_t>(effort_->steps_left, 0) + kSteps + kStepsPerByte * effort_->bytes;
  sqlite3_stmt* handle = nullptr;
  if (sqlite3_prepare_v2(handle_.get(), sql, -1, &handle, nullptr) != SQLITE_OK)
    return failure("is not a session database");
  return Statement(*this, handle);
}

Problem Database::failure(const char* what) const {
  if (is_exhausted())
    return {{path_.string()},
            fmt::format("{}: that takes more steps than {} bytes can explain", what, effort_->bytes)};
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
      if (is_plausible()) return true;
      return Problem{{database_->path().string()},
                     "is damaged: its rows would hold more bytes than the whole file"};
    case SQLITE_DONE:
      return false;
    default:
      return database_->failure("cannot be read");
  }
}

bool Statement::is_plausible() {
  if (!database_->effort_) return true;
  for (int i = 0; i < sqlite3_column_count(handle_.get()); ++i) {
    const int type = sqlite3_column_type(handle_.get(), i);
    if (type == SQLITE_BLOB || type == SQLITE_TEXT) given_bytes_ += sqlite3_column_bytes(handle_.get(), i);
  }
  return given_bytes_ <= database_->effort_->bytes;
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(handle_.get(), column);
}

std::string_view Statement::bytes(int column) const {
  const auto* data = static_cast<const char*>(sqlite3_column_blob(handle_.get(), column));
  return {data, data == nullptr ? 0 : static_cast<std::size_t>(sqlite3_column_bytes(handle_.get(), column))};
}

}  // namespace aisle::sqlite
