#pragma once

#include <string>
#include <string_view>

#include "aisle/core/problem.hpp"

namespace aisle {

/// The parts that PBM and PGM files share: numbers between blanks and comments, then perhaps bytes. The first
/// failure is kept.
class NetpbmReader {
 public:
  NetpbmReader(std::string_view bytes, std::string name) : rest_(bytes), name_(std::move(name)) {}

  /// "P1", "P4" ...
  std::string_view magic();
  /// A whole decimal number from `min` to `max`.
  int number(const char* what, int min, int max);
  /// The next character after blanks; 0 at the end.
  char character();
  /// The bytes after the one white space that ends the header; empty, with a failure, if there are fewer.
  std::string_view raw(std::size_t count);

  /// The number of bytes left, and so an upper bound on the numbers that can follow.
  std::size_t bytes_left() const { return rest_.size(); }

  void fail(std::string what);
  bool ok() const { return failure_.empty(); }
  Problem problem() const { return {{.file = name_, .line = line_}, failure_}; }

 private:
  void skip_blanks();

  std::string_view rest_;
  std::string name_;
  long line_ = 1;
  std::string failure_;
};

}  // namespace aisle
