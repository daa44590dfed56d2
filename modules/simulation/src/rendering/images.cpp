#include "rendering/images.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/core/random.hpp"

namespace aisle {
namespace {

constexpr int kSide = Texture::kSide;

struct PixelBlock {
  int left = 0, top = 0, width = 0, height = 0;
};

float& at(Texture::Image& image, int x, int y) {
  return image[static_cast<std::size_t>(y * kSide + x)];
}

void fill(Texture::Image& image, PixelBlock r, float brightness) {
  for (int y = std::max(0, r.top); y < std::min(kSide, r.top + r.height); ++y) {
    for (int x = std::max(0, r.left); x < std::min(kSide, r.left + r.width); ++x)
      at(image, x, y) = brightness;
  }
}

/// Smooth noise that repeats after `cells` of random values a side.
class Octave {
 public:
  Octave(int cells, Random& random) : cells_(cells), values_(static_cast<std::size_t>(cells * cells)) {
    for (float& value : values_) value = static_cast<float>(random.uniform(-0.5, 0.5));
  }

  float at(int x, int y) const {
    const float step = static_cast<float>(cells_) / static_cast<float>(kSide);
    const float fx = static_cast<float>(x) * step, fy = static_cast<float>(y) * step;
    const int column = static_cast<int>(fx), row = static_cast<int>(fy);
    const float sx = ease(fx - static_cast<float>(column)), sy = ease(fy - static_cast<float>(row));
    return std::lerp(std::lerp(value(column, row), value(column + 1, row), sx),
                     std::lerp(value(column, row + 1), value(column + 1, row + 1), sx), sy);
  }

 private:
  static float ease(float share) { return share * share * (3 - 2 * share); }
  float value(int column, int row) const {
    return values_[static_cast<std::size_t>(row % cells_ * cells_ + column % cells_)];
  }

  int cells_;
  std::vector<float> values_;
};

/// Lines of words, the last of a paragraph shorter.
void write_text(Texture::Image& image, PixelBlock block, int line_height, float ink, Random& random) {
  const int letter_height = std::max(1, line_height / 2);
  int line = 0;
  for (int top = block.top; top + line_height <= block.top + block.height; top += line_height, ++line) {
    const bool ends_paragraph = line % 6 == 5;
    const int width = ends_paragraph ? block.width / 2 : block.width;
    for (int x = block.left; x < block.left + width;) {
      const int word =
          std::min(static_cast<int>(random.index(static_cast<std::uint64_t>(4 * letter_height))) + 2,
                   block.left + width - x);
      fill(image, {x, top, word, letter_height}, ink);
      x += word + std::max(1, letter_height);
    }
  }
}

void show_picture(Texture::Image& image, PixelBlock frame, Random& random) {
  const float dark = static_cast<float>(random.uniform(0.1, 0.5)),
              bright = static_cast<float>(random.uniform(0.5, 0.9));
  const Octave hills(8, random);
  for (int y = frame.top; y < frame.top + frame.height; ++y) {
    for (int x = frame.left; x < frame.left + frame.width; ++x) {
      const float height = static_cast<float>(y - frame.top) / static_cast<float>(frame.height);
      at(image, x, y) = std::lerp(bright, dark, height) + 0.4f * hills.at(x, y);
    }
  }
}

}  // namespace

Texture::Image clouds(std::uint64_t seed, int coarsest_cells) {
  Random random(seed);
  Texture::Image image(std::size_t{kSide} * kSide, 0.5f);
  float strength = 0.5f;
  for (int cells = coarsest_cells; cells <= kSide; cells *= 2, strength *= 0.6f) {
    const Octave octave(cells, random);
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) at(image, x, y) += strength * octave.at(x, y);
    }
  }
  return image;
}

Texture::Image grain(std::uint64_t seed) {
  Random random(seed);
  Texture::Image image(std::size_t{kSide} * kSide);
  for (float& value : image) value = static_cast<float>(random.uniform(0.1, 0.9));
  return image;
}

Texture::Image poster_print(std::uint64_t seed) {
  Random random(seed);
  const float ink = static_cast<float>(random.uniform(0.03, 0.25));
  Texture::Image image(std::size_t{kSide} * kSide, 0.92f);
  if (random.uniform() < 0.3) fill(image, {0, 0, kSide, 44}, static_cast<float>(random.uniform(0.2, 0.6)));
  write_text(image, {20, 14, 216, 24}, 24, ink, random);
  const int image_top = 52, image_height = 50 + static_cast<int>(random.index(70));
  show_picture(image, {20, image_top, 216, image_height}, random);
  const int text_top = image_top + image_height + 12;
  write_text(image, {20, text_top, 100, 236 - text_top}, 5, ink, random);
  write_text(image, {136, text_top, 100, 236 - text_top}, 5, ink, random);
  return image;
}

Texture::Image pinned_sheets(std::uint64_t seed) {
  Random random(seed);
  Texture::Image image = clouds(seed + 1, 32);
  for (float& value : image) value = 0.42f + 0.35f * (value - 0.5f);
  constexpr int kColumns = 4, kRows = 3;
  for (int i = 0; i < kColumns * kRows; ++i) {
    if (random.uniform() < 0.2) continue;
    const int left = 10 + i % kColumns * 61 + static_cast<int>(random.index(14));
    const int top = 10 + i / kColumns * 81 + static_cast<int>(random.index(14));
    const PixelBlock sheet{left, top, 34 + static_cast<int>(random.index(10)),
                           54 + static_cast<int>(random.index(10))};
    fill(image, sheet, static_cast<float>(random.uniform(0.75, 0.95)));
    write_text(image, {left + 4, top + 5, sheet.width - 8, sheet.height - 10},
               3 + static_cast<int>(random.index(3)), 0.2f, random);
  }
  return image;
}

}  // namespace aisle
