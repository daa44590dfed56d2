#include "aisle/formats/images/portable_bitmap.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "field_reader.hpp"
#include "images/netpbm_reader.hpp"

namespace aisle {
namespace {

void read_plain(NetpbmReader& reader, PortableBitmap& bitmap) {
  const auto pixels = static_cast<std::size_t>(bitmap.width) * static_cast<std::size_t>(bitmap.height);
  bitmap.black.reserve(std::min(pixels, reader.bytes_left()));
  while (reader.ok() && bitmap.black.size() < pixels) {
    const char pixel = reader.character();
    if (pixel == 0 && reader.bytes_left() == 0) {
      reader.fail(fmt::format("ends after {} of {} pixels", bitmap.black.size(), pixels));
    } else if (pixel != '0' && pixel != '1') {
      reader.fail(fmt::format("'{}' is not a pixel; pixels are 0 and 1", printable({&pixel, 1})));
    }
    bitmap.black.push_back(pixel == '1');
  }
}

void read_raw(NetpbmReader& reader, PortableBitmap& bitmap) {
  const auto width = static_cast<std::size_t>(bitmap.width);
  const auto height = static_cast<std::size_t>(bitmap.height);
  const std::size_t row_bytes = (width + 7) / 8;
  const std::string_view bytes = reader.raw(row_bytes * height);
  if (!reader.ok()) return;
  bitmap.black.resize(width * height);
  for (std::size_t row = 0; row < height; ++row) {
    for (std::size_t column = 0; column < width; ++column) {
      const auto byte = static_cast<unsigned char>(bytes[row * row_bytes + column / 8]);
      bitmap.black[row * width + column] = (byte >> (7 - column % 8) & 1) != 0;
    }
  }
}

}  // namespace

Result<PortableBitmap> parse_pbm(std::string_view bytes, const std::string& name, int max_size) {
  NetpbmReader reader(bytes, name);
  const std::string_view magic = reader.magic();
  if (magic != "P1" && magic != "P4") reader.fail("does not begin with P1 or P4");
  PortableBitmap bitmap;
  bitmap.width = reader.number("width", 1, max_size);
  bitmap.height = reader.number("height", 1, max_size);
  if (reader.ok()) magic == "P1" ? read_plain(reader, bitmap) : read_raw(reader, bitmap);
  if (!reader.ok()) return reader.problem();
  return bitmap;
}

}  // namespace aisle
