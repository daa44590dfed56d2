#pragma once
/// The few SQLite functions that sessions and bags need.

#include <sqlite3.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "aisle/core/result.hpp"

namespace aisle::sqlite {

class Statement;

/// An open database file.
class Database {
 public:
  static Result<Database> create(const std::filesystem::path& path);
  /// Opens an existing file for reading; it may be damaged or hostile.
  static Result<Database> open(const std::filesystem::path& path);

  /// The same without changing the file or anything beside it, and as far as it goes if it is cut off. Its
  /// journals are not merged.
  static Result<Database> open_unchanged(const std::filesystem::path& path);

  /// Runs statements that return no rows. Empty on success.
  Problems run(const char* sql) const;
  Result<Statement> prepare(const char* sql) const;
  /// SQLite's message about the last failure.
  Problem failure(const char* what) const;
  const std::filesystem::path& path() const { return path_; }

 private:
  struct Close {
    void operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }
  };

  static Result<Database> open(const std::filesystem::path& path, const std::string& name, int flags,
                               const char* setup);

  std::filesystem::path path_;
  std::unique_ptr<sqlite3, Close> handle_;
};

/// A prepared statement; its parameters and columns count from 0. The database must outlive its steps.
class Statement {
 public:
  Statement(const Database& database, sqlite3_stmt* handle) : database_(&database), handle_(handle) {}

  void bind(int parameter, std::int64_t value);
  /// The bytes must live until the statement has been run or stepped to its end.
  void bind_text(int parameter, std::string_view text);
  void bind_blob(int parameter, std::string_view bytes);

  /// Runs a statement without rows and resets it, to be bound and run again. Empty on success.
  Problems run();
  /// @return whether there is another row
  Result<bool> step();

  std::int64_t integer(int column) const;
  /// Text or blob; valid until the next step.
  std::string_view bytes(int column) const;

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* handle) const { sqlite3_finalize(handle); }
  };

  const Database* database_;
  std::unique_ptr<sqlite3_stmt, Finalize> handle_;
};

}  // namespace aisle::sqlite
