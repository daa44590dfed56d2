#include "aisle/formats/json_document.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "file_limits.hpp"

namespace aisle {
namespace {

constexpr int kLevelsMax = 64;

/// Where brackets that open and do not close become too many; the text's size if they never do.
std::size_t too_deep_at(std::string_view text) {
  int levels = 0;
  bool is_in_string = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '"') is_in_string = !is_in_string;
    if (is_in_string && c == '\\') ++at;
    if (is_in_string) continue;
    if (c == '[' || c == '{') ++levels;
    if (c == ']' || c == '}') --levels;
    if (levels > kLevelsMax) return at;
  }
  return text.size();
}

}  // namespace

template <class Json>
Result<Json> parse_json(std::string_view text, const std::string& name) {
  const auto line_of = [&](std::size_t at) {
    return 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  };
  if (text.size() > kJsonBytesMax)
    return Problem{{name}, fmt::format("is larger than {} MiB of JSON", kJsonBytesMax >> 20)};
  if (const std::size_t at = too_deep_at(text); at < text.size())
    return Problem{{name, line_of(at)}, fmt::format("nests deeper than {} levels here", kLevelsMax)};
  try {
    return Json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    return Problem{{name, line_of(std::min(error.byte, text.size()))}, "is not well-formed JSON here"};
  } catch (const nlohmann::json::exception&) {
    return Problem{{name}, "has a number that is too large"};
  }
}

template Result<nlohmann::json> parse_json(std::string_view, const std::string&);
template Result<nlohmann::ordered_json> parse_json(std::string_view, const std::string&);

}  // namespace aisle
