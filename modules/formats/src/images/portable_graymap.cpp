#include "aisle/formats/images/portable_graymap.hpp"

#include <fmt/format.h>

#include "images/netpbm_reader.hpp"

namespace aisle {
namespace {

constexpr int kValueMax = 65535;

std::uint8_t grey(int value, int value_max) {
  return static_cast<std::uint8_t>((value * 255 + value_max / 2) / value_max);
}

void read_plain(NetpbmReader& reader, int value_max, Image& image) {
  for (std::uint8_t& pixel : image.bytes) {
    pixel = grey(reader.number("pixel", 0, value_max), value_max);
    if (!reader.ok()) return;
  }
}

void read_raw(NetpbmReader& reader, int value_max, Image& image) {
  const std::size_t bytes_a_pixel = value_max > 255 ? 2 : 1;
  const std::string_view bytes = reader.raw(image.bytes.size() * bytes_a_pixel);
  for (std::size_t i = 0; reader.ok() && i < image.bytes.size(); ++i) {
    int value = 0;
    for (std::size_t k = 0; k < bytes_a_pixel; ++k) {
      value = 256 * value + static_cast<unsigned char>(bytes[i * bytes_a_pixel + k]);
    }
    if (value > value_max)
      reader.fail(fmt::format("has a pixel of {}, more than the greatest value {}", value, value_max));
    image.bytes[i] = grey(value, value_max);
  }
}

}  // namespace

Result<Image> parse_pgm(std::string_view bytes, const std::string& name, int max_size) {
  NetpbmReader reader(bytes, name);
  const std::string_view magic = reader.magic();
  if (magic != "P2" && magic != "P5") reader.fail("does not begin with P2 or P5");
  const int width = reader.number("width", 1, max_size), height = reader.number("height", 1, max_size);
  const int value_max = reader.number("greatest value", 1, kValueMax);
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (pixels > reader.bytes_left()) {
    reader.fail(fmt::format("has {} bytes left for {} pixels", reader.bytes_left(), pixels));
  }
  if (!reader.ok()) return reader.problem();
  Image image(width, height);
  magic == "P2" ? read_plain(reader, value_max, image) : read_raw(reader, value_max, image);
  if (!reader.ok()) return reader.problem();
  return image;
}

}  // namespace aisle
