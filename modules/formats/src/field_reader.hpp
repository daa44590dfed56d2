#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// The number that `text` is from its first to its last character; "nan" and "inf" are numbers.
std::optional<double> parse_number(std::string_view text);

/// Takes the first line off `text`, without its line end.
std::string_view take_line(std::string_view& text);

/// A field as it may be shown to people: short and printable.
std::string printable(std::string_view field);

/// The blank-separated fields of one line, from left to right. The first thing that is wrong sticks:
/// everything read after it is 0 or empty, so that callers check once, at the end of the line.
class FieldReader {
 public:
  explicit FieldReader(std::string_view line) : rest_(line) {}

  /// The next field; empty at the end of the line, which is no failure.
  std::string_view word();
  /// The next field as a number of at most this magnitude.
  double number(const char* what, double limit);
  /// A distance: not negative; infinity is 0, "nothing seen".
  double distance(const char* what, double limit);
  /// A whole number from `min` to `max`.
  std::size_t count(const char* what, std::size_t min, std::size_t max);
  /// Three numbers: x and y in units of `scale` metres, heading.
  Pose2 pose(const char* what, double scale);
  /// How many fields are left, if they are at most `max`; reads them.
  std::size_t remaining(std::size_t max);

  void fail(std::string what);
  bool ok() const { return failure_.empty(); }
  const std::string& failure() const { return failure_; }

 private:
  double any_number(const char* what);
  double fail_field(const char* what, const char* why);

  std::string_view rest_;
  std::string_view field_;  ///< the latest that was read
  std::size_t fields_read_ = 0;
  std::string failure_;
};

}  // namespace aisle
