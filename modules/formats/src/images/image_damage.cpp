#include "images/image_damage.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <cstddef>
#include <cstdint>

#include "images/big_endian.hpp"

namespace aisle {
namespace {

constexpr std::string_view kPngSignature("\x89PNG\r\n\x1a\n", 8);
constexpr std::string_view kJpegStart("\xff\xd8\xff", 3);
constexpr std::string_view kJpegEnd("\xff\xd9", 2);
constexpr std::size_t kPngNumberBytes = 4, kPngTypeBytes = 4;

std::uint32_t checksum(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

/// A PNG is a sequence of chunks up to IEND, each with length, type, data and a checksum of type and data.
std::optional<std::string> png_damage(std::string_view bytes) {
  std::size_t at = kPngSignature.size();
  while (true) {
    constexpr std::size_t kFrame = 2 * kPngNumberBytes + kPngTypeBytes;
    const std::string_view rest = bytes.substr(at);
    if (rest.size() < kFrame || big_endian(rest) > rest.size() - kFrame)
      return fmt::format("is a PNG that is cut off after byte {}", bytes.size());
    const std::string_view typed = rest.substr(kPngNumberBytes, kPngTypeBytes + big_endian(rest));
    if (checksum(typed) != big_endian(rest.substr(kPngNumberBytes + typed.size())))
      return fmt::format("is a damaged PNG: the part at byte {} does not fit its checksum", at);
    if (typed.starts_with("IEND")) return std::nullopt;
    at += kFrame + typed.size() - kPngTypeBytes;
  }
}

}  // namespace

std::optional<std::string> image_damage(std::string_view bytes) {
  if (bytes.starts_with(kPngSignature)) return png_damage(bytes);
  if (bytes.starts_with(kJpegStart) && bytes.rfind(kJpegEnd) == std::string_view::npos)
    return fmt::format("is a JPEG that is cut off after byte {}", bytes.size());
  return std::nullopt;
}

}  // namespace aisle
