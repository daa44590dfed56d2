#include "images/netpbm_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "field_reader.hpp"

namespace aisle {
namespace {

constexpr bool is_white_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

}  // namespace

std::string_view NetpbmReader::magic() {
  const std::string_view magic = rest_.substr(0, 2);
  rest_.remove_prefix(magic.size());
  return magic;
}

void NetpbmReader::skip_blanks() {
  while (!rest_.empty() && (is_white_space(rest_.front()) || rest_.front() == '#')) {
    if (rest_.front() == '#') {
      rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
      continue;
    }
    line_ += rest_.front() == '\n';
    rest_.remove_prefix(1);
  }
}

int NetpbmReader::number(const char* what, int min, int max) {
  if (!ok()) return min;
  skip_blanks();
  const auto end = std::find_if(rest_.begin(), rest_.end(), [](char c) { return c < '0' || c > '9'; });
  const std::string_view text = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
  rest_.remove_prefix(text.size());
  const auto value = parse_number(text);
  if (value && *value >= min && *value <= max) return static_cast<int>(*value);
  fail(fmt::format("{}: '{}' is not a whole number from {} to {}", what, printable(text), min, max));
  return min;
}

char NetpbmReader::character() {
  skip_blanks();
  if (rest_.empty()) return 0;
  const char c = rest_.front();
  rest_.remove_prefix(1);
  return c;
}

std::string_view NetpbmReader::raw(std::size_t count) {
  if (!ok()) return {};
  if (rest_.empty() || !is_white_space(rest_.front())) {
    fail("a white space must end the header");
    return {};
  }
  rest_.remove_prefix(1);
  if (rest_.size() < count) {
    fail(fmt::format("ends after {} of {} bytes of pixels", rest_.size(), count));
    return {};
  }
  return rest_.substr(0, count);
}

void NetpbmReader::fail(std::string what) {
  if (ok()) failure_ = std::move(what);
}

}  // namespace aisle
