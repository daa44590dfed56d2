#include "gif_animation.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <utility>

namespace aisle {
namespace {

int append(GifFileType* file, const GifByteType* data, int size) {
  static_cast<std::string*>(file->UserData)
      ->append(reinterpret_cast<const char*>(data), static_cast<std::size_t>(size));
  return size;
}

}  // namespace

GifAnimation::GifAnimation(int width, int height, const Palette& palette) : width_(width), height_(height) {
  int error = 0;
  file_ = EGifOpen(&bytes_, append, &error);
  if (file_ == nullptr) throw std::runtime_error("GIF: " + std::string(GifErrorString(error)));
  EGifSetGifVersion(file_, true);
  const std::unique_ptr<ColorMapObject, decltype(&GifFreeMapObject)> colors(
      GifMakeMapObject(static_cast<int>(palette.size()), palette.data()), GifFreeMapObject);
  require(EGifPutScreenDesc(file_, width, height, 8, 0, colors.get()));
  begin_loop();
}

GifAnimation::~GifAnimation() {
  if (file_ != nullptr) EGifCloseFile(file_, nullptr);
}

/// The extension that makes viewers repeat an animation.
void GifAnimation::begin_loop() {
  constexpr GifByteType kForEver[] = {1, 0, 0};
  require(EGifPutExtensionLeader(file_, APPLICATION_EXT_FUNC_CODE));
  require(EGifPutExtensionBlock(file_, 11, "NETSCAPE2.0"));
  require(EGifPutExtensionBlock(file_, sizeof kForEver, kForEver));
  require(EGifPutExtensionTrailer(file_));
}

GifAnimation::Box GifAnimation::changed_box(const std::vector<std::uint8_t>& pixels) const {
  if (shown_.empty()) return {0, 0, width_, height_};
  Box box{width_, height_, 0, 0};
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const auto at =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
      if (pixels[at] == shown_[at]) continue;
      box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x + 1),
             std::max(box.bottom, y + 1)};
    }
  }
  return box.right == 0 ? Box{0, 0, 1, 1} : box;
}

void GifAnimation::add_frame(const std::vector<std::uint8_t>& pixels, int hundredths_s) {
  const Box box = changed_box(pixels);
  const GraphicsControlBlock control{DISPOSE_DO_NOT, false, hundredths_s, NO_TRANSPARENT_COLOR};
  std::array<GifByteType, 4> extension{};
  EGifGCBToExtension(&control, extension.data());
  require(EGifPutExtension(file_, GRAPHICS_EXT_FUNC_CODE, extension.size(), extension.data()));
  require(
      EGifPutImageDesc(file_, box.left, box.top, box.right - box.left, box.bottom - box.top, false, nullptr));
  shown_ = pixels;
  for (int y = box.top; y < box.bottom; ++y) {
    require(EGifPutLine(file_, shown_.data() + std::ptrdiff_t{y} * width_ + box.left, box.right - box.left));
  }
  shown_ = pixels;  // giflib masks the row that it is given
}

std::string GifAnimation::finish() {
  const int closed = EGifCloseFile(std::exchange(file_, nullptr), nullptr);
  if (closed != GIF_OK) throw std::runtime_error("GIF: the file cannot be closed");
  return std::move(bytes_);
}

void GifAnimation::require(int gif_result) const {
  if (gif_result != GIF_OK) throw std::runtime_error("GIF: " + std::string(GifErrorString(file_->Error)));
}

}  // namespace aisle
