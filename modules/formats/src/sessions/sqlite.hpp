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
#include "unpacking_directory.hpp"

namespace aisle::sqlite {

class Statement;

/// An open database file.
class Database {
 public:
  static Result<Database> create(const std::filesystem::path& path);

  /// Opens an existing file for reading; it may be damaged or hostile. Neither the file nor anything beside
  /// it changes, and no view or trigger of its runs: with journals that wait to be merged, a copy is opened.
  /// A statement that takes more steps, or gives more bytes, than the size of the file can explain is a
  /// problem.
  static Result<Database> open(const std::filesystem::path& path);

  /// The same of a file that is shorter than its header says, as far as it goes.
  static Result<Database> open_cut(const std::filesystem::path& path);

  /// Runs statements that return no rows. Empty on success.
  Problems run(const char* sql) const;
  Result<Statement> prepare(const char* sql) const;
  /// SQLite's message about the last failure.
  Problem failure(const char* what) const;
  const std::filesystem::path& path() const { return path_; }
  /// Whether journals waited beside the file, so that a copy was opened.
  bool is_copy() const { return copy_.has_value(); }

 private:
  friend class Statement;

  struct Close {
    void operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }
  };

  /// What reading may cost.
  struct Effort {
    std::int64_t bytes = 0;       ///< of the file with its journals
    std::int64_t steps_left = 0;  ///< of SQLite's machine
  };

  Problems open_handle(const std::string& name, int flags);
  Problems read_only(const char* setup);
  Problems copy_with_journals();
  bool is_exhausted() const { return effort_ && effort_->steps_left < 0; }

  std::filesystem::path path_;
  std::optional<UnpackingDirectory> copy_;
  std::unique_ptr<Effort> effort_;  ///< none: of a file that is written
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

  /// Counts the bytes of the row at hand; false if they are more than the file can hold.
  bool is_plausible();

  const Database* database_;
  std::unique_ptr<sqlite3_stmt, Finalize> handle_;
  std::int64_t given_bytes_ = 0;
};

}  // namespace aisle::sqlite
