#include "field_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace aisle {
namespace {

constexpr double kPoseLimit_m = 1e7;
constexpr double kHeadingLimit_rad = 1e6;

constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

/// `text` such as "12.34": at most 15 digits, no exponent. Both the digits and the power of ten are then
/// exact as doubles and their quotient is the correctly rounded value, at a fraction of std::from_chars'
/// time.
std::optional<double> parse_plain_decimal(std::string_view text) {
  constexpr std::array<double, 16> kPowersOfTen = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                   1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const bool negative = !text.empty() && text.front() == '-';
  if (negative) text.remove_prefix(1);
  if (text.empty() || text.size() > 16) return std::nullopt;
  std::int64_t digits = 0;
  std::size_t digit_count = 0;
  std::size_t after_point = 0;
  bool has_point = false;
  for (const char c : text) {
    if (c >= '0' && c <= '9') {
      digits = 10 * digits + (c - '0');
      ++digit_count;
      after_point += has_point;
    } else if (c == '.' && !has_point) {
      has_point = true;
    } else {
      return std::nullopt;
    }
  }
  if (digit_count == 0 || digit_count > 15) return std::nullopt;
  const double magnitude = static_cast<double>(digits) / kPowersOfTen[after_point];
  return negative ? -magnitude : magnitude;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  if (const auto plain = parse_plain_decimal(text)) return plain;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string_view trimmed(std::string_view text, std::string_view around) {
  const std::size_t first = text.find_first_not_of(around);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(around) - first + 1);
}

std::string printable(std::string_view field) {
  std::string text(field.substr(0, 24));
  for (char& c : text) {
    if (c < 0x20 || c > 0x7e) c = '?';
  }
  return field.size() > 24 ? text + "..." : text;
}

std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line;
}

std::string_view FieldReader::word() {
  std::size_t start = 0;
  while (start < rest_.size() && is_blank(rest_[start])) ++start;
  std::size_t end = start;
  while (end < rest_.size() && !is_blank(rest_[end])) ++end;
  field_ = rest_.substr(start, end - start);
  rest_.remove_prefix(end);
  fields_read_ += !field_.empty();
  return field_;
}

void FieldReader::fail(std::string what) {
  if (ok()) failure_ = std::move(what);
  rest_ = {};
}

double FieldReader::fail_field(const char* what, const char* why) {
  fail(fmt::format("field {}, {}: '{}' {}", fields_read_, what, printable(field_), why));
  return 0;
}

double FieldReader::any_number(const char* what) {
  if (word().empty()) {
    fail(fmt::format("the line ends after {} fields, before its {}; it seems to be cut off", fields_read_,
                     what));
    return 0;
  }
  const auto value = parse_number(field_);
  return value ? *value : fail_field(what, "is not a number");
}

double FieldReader::number_but_nan(const char* what) {
  const double value = any_number(what);
  return std::isnan(value) ? fail_field(what, "is not a usable number") : value;
}

double FieldReader::number(const char* what, double limit) {
  const double value = number_but_nan(what);
  if (std::abs(value) > limit) return fail_field(what, "is absurdly large");
  return value;
}

double FieldReader::distance(const char* what, double limit) {
  const double value = number_but_nan(what);
  if (value < 0) return fail_field(what, "is negative");
  if (std::isinf(value)) return 0;
  if (value > limit) return fail_field(what, "is absurdly large");
  return value;
}

std::size_t FieldReader::count(const char* what, std::size_t min, std::size_t max) {
  const double value = number(what, 1e15);
  if (!ok()) return 0;
  if (value >= static_cast<double>(min) && value <= static_cast<double>(max) && value == std::floor(value)) {
    return static_cast<std::size_t>(value);
  }
  fail(fmt::format("field {}, {}: {:g} is not a whole number from {} to {}", fields_read_, what, value, min,
                   max));
  return 0;
}

Pose2 FieldReader::pose(const char* what, double scale) {
  Pose2 pose;
  pose.x = number(what, kPoseLimit_m / scale) * scale;
  pose.y = number(what, kPoseLimit_m / scale) * scale;
  pose.theta = number(what, kHeadingLimit_rad);
  return pose;
}

std::size_t FieldReader::remaining(std::size_t max) {
  std::size_t count = 0;
  while (count <= max && !word().empty()) ++count;
  if (count > max) fail("the line has more fields than it announces");
  return count;
}

}  // namespace aisle
