#include "aisle/formats/portable_bitmap.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "field_reader.hpp"

namespace aisle {
namespace {

constexpr bool is_white_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

class BitmapParser {
 public:
  BitmapParser(std::string_view bytes, const std::string& name, int max_size)
      : rest_(bytes), name_(name), max_size_(max_size) {}

  Result<PortableBitmap> parse() {
    const std::string_view magic = rest_.substr(0, 2);
    if (magic != "P1" && magic != "P4") return problem("does not begin with P1 or P4");
    rest_.remove_prefix(2);
    PortableBitmap bitmap;
    bitmap.width = size("width");
    bitmap.height = size("height");
    if (!failure_.empty()) return problem(failure_);
    return magic == "P1" ? read_plain(std::move(bitmap)) : read_raw(std::move(bitmap));
  }

 private:
  Problem problem(std::string what) const { return Problem{{.file = name_, .line = line_}, std::move(what)}; }

  void skip_blanks() {
    while (!rest_.empty() && (is_white_space(rest_.front()) || rest_.front() == '#')) {
      if (rest_.front() == '#') {
        rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
        continue;
      }
      line_ += rest_.front() == '\n';
      rest_.remove_prefix(1);
    }
  }

  int size(const char* what) {
    skip_blanks();
    std::size_t digits = 0;
    while (digits < rest_.size() && rest_[digits] >= '0' && rest_[digits] <= '9') ++digits;
    const std::string_view text = rest_.substr(0, digits);
    rest_.remove_prefix(digits);
    const auto value = parse_number(text);
    if (value && *value >= 1 && *value <= max_size_) return static_cast<int>(*value);
    if (failure_.empty()) {
      failure_ = fmt::format("{}: '{}' is not a whole number from 1 to {}", what, printable(text), max_size_);
    }
    return 0;
  }

  Result<PortableBitmap> read_plain(PortableBitmap bitmap) {
    const auto pixels = static_cast<std::size_t>(bitmap.width) * static_cast<std::size_t>(bitmap.height);
    bitmap.black.reserve(std::min(pixels, rest_.size()));
    while (bitmap.black.size() < pixels) {
      skip_blanks();
      if (rest_.empty())
        return problem(fmt::format("ends after {} of {} pixels", bitmap.black.size(), pixels));
      const char pixel = rest_.front();
      if (pixel != '0' && pixel != '1') {
        return problem(fmt::format("'{}' is no pixel; 0 and 1 are", printable(rest_.substr(0, 1))));
      }
      bitmap.black.push_back(pixel == '1');
      rest_.remove_prefix(1);
    }
    return bitmap;
  }

  Result<PortableBitmap> read_raw(PortableBitmap bitmap) {
    if (rest_.empty() || !is_white_space(rest_.front()))
      return problem("a white space must follow the height");
    rest_.remove_prefix(1);
    const auto width = static_cast<std::size_t>(bitmap.width);
    const auto height = static_cast<std::size_t>(bitmap.height);
    const std::size_t row_bytes = (width + 7) / 8;
    if (rest_.size() < row_bytes * height) {
      return problem(fmt::format("ends after {} of {} bytes of pixels", rest_.size(), row_bytes * height));
    }
    bitmap.black.resize(width * height);
    for (std::size_t row = 0; row < height; ++row) {
      for (std::size_t column = 0; column < width; ++column) {
        const auto byte = static_cast<unsigned char>(rest_[row * row_bytes + column / 8]);
        bitmap.black[row * width + column] = (byte >> (7 - column % 8) & 1) != 0;
      }
    }
    return bitmap;
  }

  std::string_view rest_;
  std::string name_;
  int max_size_;
  long line_ = 1;
  std::string failure_;
};

}  // namespace

Result<PortableBitmap> parse_pbm(std::string_view bytes, const std::string& name, int max_size) {
  return BitmapParser(bytes, name, max_size).parse();
}

}  // namespace aisle
