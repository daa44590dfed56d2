#pragma once
/// MRPT's binary serialization: little-endian values, and objects that name their class and version.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

namespace aisle {

/// An object begins with the length of its class name (highest bit set), the name, and its version.
struct MrptHeader {
  std::string_view class_name;  ///< without its namespace
  int version = 0;
};

/// Reads from left to right. The first failure is kept; everything read after it is 0 or empty.
class MrptStream {
 public:
  explicit MrptStream(std::string_view bytes) : bytes_(bytes) {}

  template <class Value>
  Value read() {
    Value value{};
    if (!take(sizeof(Value))) return value;
    std::memcpy(&value, bytes_.data() + position_ - sizeof(Value), sizeof(Value));
    return value;
  }
  /// Its length (4 bytes), then its characters.
  std::string_view read_string();
  std::string_view read_bytes(std::size_t count);
  void skip(std::size_t count) { take(count); }

  /// The header of the object that begins here.
  MrptHeader read_header();
  /// One of this class; a failure if it is another, or newer than `latest_version`.
  int read_header_of(std::string_view class_name, int latest_version);
  void read_end_of_object();

  /// Moves on to where the next observation, action or frame begins, whatever is between.
  /// @return false if there is none
  bool seek_next_record();

  bool is_at_end() const { return position_ >= bytes_.size(); }
  std::size_t position() const { return position_; }
  /// Whether `count` values of `size` bytes are left, so that memory for them may be taken.
  bool has(std::size_t count, std::size_t size) const { return count <= (bytes_.size() - position_) / size; }

  bool is_at_end_flag() const;
  void skip_to_end() { position_ = bytes_.size(); }

  void fail(std::string what);
  void forget_failure();
  bool ok() const { return failure_.empty(); }
  bool is_cut_off() const { return is_cut_off_; }
  const std::string& failure() const { return failure_; }

 private:
  static_assert(std::endian::native == std::endian::little);
  bool take(std::size_t count);
  std::optional<MrptHeader> header_at(std::size_t position) const;

  std::string_view bytes_;
  std::size_t position_ = 0;
  std::string failure_;
  bool is_cut_off_ = false;
};

inline constexpr unsigned char kMrptEndOfObject = 0x88;

/// Whether an object of this class is a part of a rawlog, not of an object in it.
bool is_rawlog_record(std::string_view class_name);

/// Whether a file with these first bytes, unpacked, is a rawlog.
bool begins_rawlog(std::string_view head);

}  // namespace aisle
