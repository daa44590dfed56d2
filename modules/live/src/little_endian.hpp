#pragma once
/// Numbers in the protocol's binary messages.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace aisle {

template <class Number>
void append_little_endian(std::string& bytes, Number number) {
  for (unsigned shift = 0; shift < 8 * sizeof(Number); shift += 8)
    bytes.push_back(static_cast<char>(number >> shift & 0xff));
}

/// Reads one value after the other from the front; nullopt if too few bytes are left.
class LittleEndianReader {
 public:
  explicit LittleEndianReader(std::string_view bytes) : rest_(bytes) {}

  std::optional<char> byte() {
    const auto taken = bytes(1);
    return taken ? std::optional(taken->front()) : std::nullopt;
  }

  std::optional<std::uint32_t> uint32() { return number<std::uint32_t>(); }
  std::optional<std::uint64_t> uint64() { return number<std::uint64_t>(); }

  std::optional<std::string_view> bytes(std::size_t count) {
    if (count > rest_.size()) return std::nullopt;
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }

  std::string_view rest() const { return rest_; }

 private:
  template <class Number>
  std::optional<Number> number() {
    const auto taken = bytes(sizeof(Number));
    if (!taken) return std::nullopt;
    Number number = 0;
    for (std::size_t i = sizeof(number); i-- > 0;)
      number = number << 8 | static_cast<std::uint8_t>((*taken)[i]);
    return number;
  }

  std::string_view rest_;
};

}  // namespace aisle
