#include "images/image_size.hpp"

#include <cstdlib>

#include "images/netpbm_reader.hpp"

namespace aisle {
namespace {

using namespace std::string_view_literals;

enum class ByteOrder : std::uint8_t { kLittleEndian, kBigEndian };

/// Numbers at places of a file; a place beyond its end fails the reading.
class HeadReader {
 public:
  HeadReader(std::string_view bytes, ByteOrder order) : bytes_(bytes), order_(order) {}

  std::uint64_t number(std::uint64_t at, std::uint64_t size) {
    if (at > bytes_.size() || bytes_.size() - at < size) {
      ok_ = false;
      return 0;
    }
    std::uint64_t value = 0;
    for (std::uint64_t i = 0; i < size; ++i) {
      const std::uint64_t from = order_ == ByteOrder::kBigEndian ? i : size - 1 - i;
      value = value << 8 | static_cast<unsigned char>(bytes_[static_cast<std::size_t>(at + from)]);
    }
    return value;
  }
  bool ok() const { return ok_; }
  std::optional<ImageSize> size_at(std::uint64_t width_at, std::uint64_t height_at, std::uint64_t size) {
    const ImageSize stated{number(width_at, size), number(height_at, size)};
    return ok_ ? std::optional(stated) : std::nullopt;
  }

 private:
  std::string_view bytes_;
  ByteOrder order_;
  bool ok_ = true;
};

/// A JPEG is a sequence of marked parts; the frame's, SOF0 to SOF15 without DHT, JPG and DAC, states the
/// size.
std::optional<ImageSize> jpeg_size(HeadReader head) {
  for (std::uint64_t at = 2; head.number(at, 1) == 0xff && head.ok();) {
    const std::uint64_t mark = head.number(at + 1, 1);
    const bool is_frame = mark >= 0xc0 && mark <= 0xcf && mark != 0xc4 && mark != 0xc8 && mark != 0xcc;
    if (is_frame) return head.size_at(at + 7, at + 5, 2);
    const bool is_alone = mark == 0xff || mark == 0x01 || (mark >= 0xd0 && mark <= 0xd8);
    at += mark == 0xff ? 1 : is_alone ? 2 : 2 + head.number(at + 2, 2);
  }
  return std::nullopt;
}

std::optional<ImageSize> bmp_size(HeadReader head) {
  constexpr std::uint64_t kOldHead = 12;
  if (head.number(14, 4) == kOldHead) return head.size_at(18, 20, 2);
  auto size = head.size_at(18, 22, 4);
  if (!size) return std::nullopt;
  const auto rows = static_cast<std::int32_t>(static_cast<std::uint32_t>(size->height_px));
  size->height_px =
      static_cast<std::uint64_t>(std::abs(static_cast<std::int64_t>(rows)));  // < 0: from the top
  return size;
}

/// A TIFF has a table of entries of 12 bytes: tag, type, count, value.
std::optional<ImageSize> tiff_size(HeadReader head) {
  constexpr std::uint64_t kWidthTag = 256, kHeightTag = 257, kShort = 3;
  const std::uint64_t table = head.number(4, 4), entries = head.number(table, 2);
  ImageSize size;
  for (std::uint64_t i = 0; i < entries && head.ok(); ++i) {
    const std::uint64_t entry = table + 2 + 12 * i, tag = head.number(entry, 2);
    const std::uint64_t value = head.number(entry + 8, head.number(entry + 2, 2) == kShort ? 2 : 4);
    if (tag == kWidthTag) size.width_px = value;
    if (tag == kHeightTag) size.height_px = value;
  }
  return size.width_px > 0 && size.height_px > 0 && head.ok() ? std::optional(size) : std::nullopt;
}

/// Sides have 14 bits in both simple kinds, 24 bits less one in the extended one.
std::optional<ImageSize> webp_size(std::string_view bytes) {
  constexpr std::uint64_t kSideBits = 14, kSideMask = (1U << kSideBits) - 1;
  HeadReader head(bytes, ByteOrder::kLittleEndian);
  const std::string_view kind = bytes.substr(12, 4);
  ImageSize size;
  if (kind == "VP8X") {
    size = {1 + head.number(24, 3), 1 + head.number(27, 3)};
  } else if (kind == "VP8L") {
    const std::uint64_t sides = head.number(21, 4);
    size = {1 + (sides & kSideMask), 1 + (sides >> kSideBits & kSideMask)};
  } else if (kind == "VP8 ") {
    size = {head.number(26, 2) & kSideMask, head.number(28, 2) & kSideMask};
  } else {
    return std::nullopt;
  }
  return head.ok() ? std::optional(size) : std::nullopt;
}

std::optional<ImageSize> netpbm_size(std::string_view bytes) {
  constexpr int kAnySide = 1'000'000'000;
  NetpbmReader head(bytes, "");
  head.magic();
  const int width = head.number("width", 1, kAnySide), height = head.number("height", 1, kAnySide);
  if (!head.ok()) return std::nullopt;
  return ImageSize{static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height)};
}

}  // namespace

std::optional<ImageSize> stated_image_size(std::string_view bytes) {
  HeadReader big(bytes, ByteOrder::kBigEndian), little(bytes, ByteOrder::kLittleEndian);
  if (bytes.starts_with("\x89PNG\r\n\x1a\n"sv)) return big.size_at(16, 20, 4);
  if (bytes.starts_with("\xff\xd8\xff"sv)) return jpeg_size(big);
  if (bytes.starts_with("RIFF"sv) && bytes.substr(0, 12).ends_with("WEBP"sv)) return webp_size(bytes);
  if (bytes.starts_with("BM"sv)) return bmp_size(little);
  if (bytes.starts_with("II*\0"sv)) return tiff_size(little);
  if (bytes.starts_with("MM\0*"sv)) return tiff_size(big);
  if (bytes.size() > 1 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6') return netpbm_size(bytes);
  return std::nullopt;
}

}  // namespace aisle
