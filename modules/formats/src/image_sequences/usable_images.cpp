#include "image_sequences/usable_images.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "aisle/formats/images/image_file.hpp"

namespace aisle {
namespace {

constexpr int kSideMin_px = 16, kSideMax_px = 8192;  // what a vehicle's description may say of a camera

bool is_jpeg_or_png(std::string_view bytes) {
  return bytes.starts_with("\xff\xd8\xff") || bytes.starts_with("\x89PNG");
}

Problems check_sides(const Image& image, const std::string& name) {
  if (std::min(image.width_px, image.height_px) >= kSideMin_px &&
      std::max(image.width_px, image.height_px) <= kSideMax_px)
    return {};
  return {{{name},
           fmt::format("has {} x {} pixels, not {} to {} a side", image.width_px, image.height_px,
                       kSideMin_px, kSideMax_px)}};
}

}  // namespace

Result<UsableImage> usable_file(std::string_view bytes, const std::string& name) {
  const auto pixels = parse_image(bytes, name);
  if (!pixels) return pixels.problems();
  return usable(*pixels, bytes, name);
}

Result<UsableImage> usable(const Image& image, std::string_view file, const std::string& name) {
  if (Problems problems = check_sides(image, name); !problems.empty()) return problems;
  return UsableImage{is_jpeg_or_png(file) ? std::string(file) : png_bytes(image), image.width_px,
                     image.height_px};
}

void UsableImages::leave_out(const std::string& kind, const LeftOut& several) {
  if (several.count() > 0) left_out_[kind] = several;
}

Problems UsableImages::begin() {
  auto first = take();
  if (!first) return first.problems();
  ahead_ = std::move(*first);
  if (ahead_) return {};
  if (left_out_.empty()) return {{{recording_}, "has no images"}};
  const Problem& why = left_out_.begin()->second.first();
  return {{why.where, fmt::format("{}; none of the images of {} can be used", why.what, recording_)}};
}

Result<std::optional<TimedImage>> UsableImages::next() {
  if (!ahead_) return std::optional<TimedImage>();
  auto following = take();
  if (!following) return following.problems();
  return std::exchange(ahead_, std::move(*following));
}

/// The next image of the first one's size.
Result<std::optional<TimedImage>> UsableImages::take() {
  while (true) {
    auto candidate = next_candidate();
    if (!candidate) return candidate.problems();
    if (!*candidate) return std::optional<TimedImage>();
    UsableImage& usable = (*candidate)->usable;
    if (width_px_ == 0) width_px_ = usable.width_px, height_px_ = usable.height_px;
    if (usable.width_px == width_px_ && usable.height_px == height_px_) {
      (*candidate)->image.bytes = std::move(usable.bytes);
      return std::optional(std::move((*candidate)->image));
    }
    leave_out("image",
              {(*candidate)->place, fmt::format("has {} x {} pixels, the first image {} x {}",
                                                usable.width_px, usable.height_px, width_px_, height_px_)});
  }
}

std::size_t UsableImages::left_out() const {
  std::size_t count = 0;
  for (const auto& [kind, several] : left_out_) count += several.count();
  return count;
}

Problems UsableImages::warnings() const {
  Problems warnings = warnings_;
  for (const auto& [kind, several] : left_out_) several.warn(kind, warnings);
  return warnings;
}

}  // namespace aisle
