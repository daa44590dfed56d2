#pragma once
/// ROS 2 messages as bytes: four bytes of encapsulation, then plain CDR (XCDR1), little endian.

#include <array>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

namespace robots {

inline constexpr std::string_view kEncapsulation{"\0\1\0\0", 4};

template <typename T>
concept CdrNumber = std::is_arithmetic_v<T>;

/// A message type lists its members in the order of its specification: `static auto fields(auto& message)`.
template <typename T>
concept CdrMessage = requires(T& message) {
  T::fields(message);
};

class CdrWriter {
 public:
  std::string take() && { return std::move(bytes_); }

  void put(CdrNumber auto value) { put_numbers(&value, 1); }

  void put(const std::string& text) {
    put(static_cast<std::uint32_t>(text.size() + 1));
    bytes_.append(text.c_str(), text.size() + 1);
  }

  template <typename Item>
  void put(const std::vector<Item>& items) {
    put(static_cast<std::uint32_t>(items.size()));
    if constexpr (CdrNumber<Item>) {
      put_numbers(items.data(), items.size());
    } else {
      for (const Item& item : items) put(item);
    }
  }

  template <CdrNumber Number, std::size_t kCount>
  void put(const std::array<Number, kCount>& numbers) {
    put_numbers(numbers.data(), kCount);
  }

  template <CdrMessage Message>
  void put(const Message& message) {
    std::apply([this](const auto&... field) { (this->put(field), ...); }, Message::fields(message));
  }

 private:
  template <CdrNumber Number>
  void put_numbers(const Number* numbers, std::size_t count) {
    if (count == 0) return;
    // Numbers lie at multiples of their size, counted from the end of the encapsulation.
    while ((bytes_.size() - kEncapsulation.size()) % sizeof(Number) != 0) bytes_.push_back('\0');
    bytes_.append(reinterpret_cast<const char*>(numbers), count * sizeof(Number));
  }

  std::string bytes_{kEncapsulation};
};

/// Reads what CdrWriter writes. The first thing that does not fit spoils the reader; what is read then is
/// zero.
class CdrReader {
 public:
  explicit CdrReader(std::string_view bytes) : bytes_(bytes), good_(bytes.starts_with(kEncapsulation)) {}

  bool good() const { return good_; }

  void get(CdrNumber auto& value) { get_numbers(&value, 1); }

  void get(std::string& text) {
    const std::size_t size = get_count();
    if (size == 0 || !good_) return;
    text.assign(bytes_.substr(at_, size - 1));
    at_ += size;
  }

  template <typename Item>
  void get(std::vector<Item>& items) {
    items.resize(get_count());
    if constexpr (CdrNumber<Item>) {
      get_numbers(items.data(), items.size());
    } else {
      for (Item& item : items) get(item);
    }
  }

  template <CdrNumber Number, std::size_t kCount>
  void get(std::array<Number, kCount>& numbers) {
    get_numbers(numbers.data(), kCount);
  }

  template <CdrMessage Message>
  void get(Message& message) {
    std::apply([this](auto&... field) { (this->get(field), ...); }, Message::fields(message));
  }

 private:
  /// No item is smaller than a byte, so a count beyond the bytes that are left is a lie.
  std::size_t get_count() {
    std::uint32_t count = 0;
    get(count);
    good_ = good_ && count <= bytes_.size() - at_;
    return good_ ? count : 0;
  }

  template <CdrNumber Number>
  void get_numbers(Number* numbers, std::size_t count) {
    if (count == 0) return;
    const std::size_t misaligned = (at_ - kEncapsulation.size()) % sizeof(Number);
    const std::size_t start = misaligned == 0 ? at_ : at_ + sizeof(Number) - misaligned;
    good_ = good_ && start <= bytes_.size() && count <= (bytes_.size() - start) / sizeof(Number);
    if (!good_) return;
    std::memcpy(numbers, bytes_.data() + start, count * sizeof(Number));
    at_ = start + count * sizeof(Number);
  }

  std::string_view bytes_;
  std::size_t at_ = kEncapsulation.size();
  bool good_;
};

template <CdrMessage Message>
std::string to_cdr(const Message& message) {
  CdrWriter writer;
  writer.put(message);
  return std::move(writer).take();
}

/// @return nothing if the bytes are too few, or not of this encapsulation
template <CdrMessage Message>
std::optional<Message> from_cdr(std::string_view bytes) {
  CdrReader reader(bytes);
  Message message;
  reader.get(message);
  return reader.good() ? std::optional(std::move(message)) : std::nullopt;
}

}  // namespace robots
