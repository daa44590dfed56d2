#include "aisle/core/terminal_text.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <optional>

namespace aisle {
namespace {

struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 1;
};

/// The UTF-8 character that the text begins with; none if these bytes are not the shortest form of one.
std::optional<Character> first_character(std::string_view text) {
  const auto byte = [&](std::size_t at) { return static_cast<std::uint8_t>(text[at]); };
  const std::uint8_t first = byte(0);
  if (first < 0x80) return Character{first, 1};
  const std::size_t bytes = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() < bytes) return std::nullopt;
  std::uint32_t code = first & (0x7fU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0U) != 0x80) return std::nullopt;
    code = code << 6 | (byte(i) & 0x3fU);
  }
  const bool is_long = (bytes == 3 && code < 0x800) || (bytes == 4 && code < 0x10000);
  const bool is_half = code >= 0xd800 && code <= 0xdfff;
  if (is_long || is_half || code > 0x10ffff) return std::nullopt;
  return Character{code, bytes};
}

bool is_shown(std::uint32_t code) {
  const bool is_control = code < 0x20 || (code >= 0x7f && code < 0xa0);
  const bool turns_direction = code == 0x61c || code == 0x200e || code == 0x200f ||
                               (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
  return code == '\n' || code == '\t' || !(is_control || turns_direction);
}

}  // namespace

std::string terminal_text(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    const auto character = first_character(text);
    const std::size_t bytes = character ? character->bytes : 1;
    if (!character) {
      shown += fmt::format("\\x{:02x}", static_cast<std::uint8_t>(text[0]));
    } else if (is_shown(character->code)) {
      shown += text.substr(0, bytes);
    } else {
      shown += character->code < 0x80 ? fmt::format("\\x{:02x}", character->code)
                                      : fmt::format("\\u{:04x}", character->code);
    }
    text.remove_prefix(bytes);
  }
  return shown;
}

}  // namespace aisle
