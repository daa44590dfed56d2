#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// The number if `text` is exactly one, from its first to its last character; "nan" and "inf" are numbers.
std::optional<double> parse_number(std::string_view text);

/// Takes the first line off `text`, without its line end.
std::string_view take_line(std::string_view& text);

/// Spreadsheets begin a text with it.
inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

/// The text without these characters around it.
std::string_view trimmed(std::string_view text, std::string_view around = " \t\r");

/// The field as it may be shown to people: short and printable.
std::string printable(std::string_view field);

/// The blank-separated fields of one line, from left to right. The first failure is kept; everything read
/// after it is 0 or empty. So callers check once, at the end of the line.
class FieldReader {
 public:
  explicit FieldReader(std::string_view line) : rest_(line) {}

  /// The next field; empty at the end of the line, which is not a failure.
  std::string_view word();
  /// The next field as any number; NaN and infinity are numbers.
  double any_number(const char* what);
  /// The next field as a number of magnitude `limit` or less.
  double number(const char* what, double limit);
  /// A distance: not negative; infinity becomes 0, "nothing seen".
  double distance(const char* what, double limit);
  /// A whole number from `min` to `max`.
  std::size_t count(const char* what, std::size_t min, std::size_t max);
  /// Three numbers: x and y in units of `scale` metres, heading.
  Pose2 pose(const char* what, double scale);
  /// Counts the remaining fields and reads them; fails if there are more than `max`.
  std::size_t remaining(std::size_t max);

  void fail(std::string what);
  bool ok() const { return failure_.empty(); }
  const std::string& failure() const { return failure_; }

 private:
  double number_but_nan(const char* what);
  double fail_field(const char* what, const char* why);

  std::string_view rest_;
  std::string_view field_;  ///< the latest that was read
  std::size_t fields_read_ = 0;
  std::string failure_;
};

}  // namespace aisle
