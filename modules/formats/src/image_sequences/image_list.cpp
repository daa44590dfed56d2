#include "image_sequences/image_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "aisle/core/median.hpp"
#include "aisle/formats/images/image_file.hpp"
#include "aisle/formats/whole_file.hpp"

namespace aisle {
namespace {

constexpr std::size_t kFileBytesMax = std::size_t{64} << 20;
constexpr int kSideMin_px = 16, kSideMax_px = 8192;  // what a vehicle's description may say of a camera
constexpr double kPause_s = 5;

/// An image whose bytes can be decoded.
struct UsableImage {
  TimedImage image;
  int width_px = 0;
  int height_px = 0;
};

bool is_jpeg_or_png(std::string_view bytes) {
  return bytes.starts_with("\xff\xd8\xff") || bytes.starts_with("\x89PNG");
}

/// A picture is decoded once, so that no reader of the session meets one that cannot be.
Result<UsableImage> read_usable(const ListedImage& listed) {
  auto bytes = read_whole_file(listed.file, kFileBytesMax);
  if (!bytes) return bytes.problems();
  const auto pixels = parse_image(*bytes, listed.file.string());
  if (!pixels) return pixels.problems();
  if (std::min(pixels->width_px, pixels->height_px) < kSideMin_px ||
      std::max(pixels->width_px, pixels->height_px) > kSideMax_px) {
    return Problem{{listed.file.string()},
                   fmt::format("has {} x {} pixels, not {} to {} a side", pixels->width_px, pixels->height_px,
                               kSideMin_px, kSideMax_px)};
  }
  return UsableImage{{.stamp_s = listed.stamp_s,
                      .bytes = is_jpeg_or_png(*bytes) ? std::move(*bytes) : png_bytes(*pixels),
                      .T_odom_vehicle = listed.T_odom_vehicle,
                      .controls = listed.controls},
                     pixels->width_px,
                     pixels->height_px};
}

std::vector<double> steps_of(const std::vector<ListedImage>& images) {
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < images.size(); ++i)
    steps_s.push_back(images[i].stamp_s - images[i - 1].stamp_s);
  return steps_s;
}

/// Pauses are part of a session's duration, so they are mentioned.
void warn_of_pauses(const std::vector<double>& steps_s, const std::string& recording, Problems& warnings) {
  const auto pauses = std::count_if(steps_s.begin(), steps_s.end(), [](double s) { return s > kPause_s; });
  if (pauses == 0) return;
  warnings.push_back(
      {{recording},
       fmt::format("has pauses of more than {:g} s ({}, the longest of {:.0f} s): it may be several "
                   "recordings in one, and aisle cut takes a part",
                   kPause_s, pauses, *std::max_element(steps_s.begin(), steps_s.end()))});
}

class ListedSequence final : public ImageSequence {
 public:
  explicit ListedSequence(ImageList list) : list_(std::move(list)) {
    const std::vector<double> steps_s = steps_of(list_.images);
    if (!steps_s.empty()) period_s_ = median(steps_s);
    warn_of_pauses(steps_s, list_.recording.string(), list_.warnings);
  }

  /// Finds the first usable image, which tells the size of all.
  Problems begin() {
    ahead_ = take_usable();
    if (!ahead_) return {nothing_usable()};
    width_px_ = ahead_->width_px;
    height_px_ = ahead_->height_px;
    return {};
  }

  int width_px() const override { return width_px_; }
  int height_px() const override { return height_px_; }
  bool has_odometry() const override { return list_.has_odometry; }
  double period_s() const override { return period_s_; }
  std::size_t size() const override { return list_.images.size(); }

  Result<std::optional<TimedImage>> next() override {
    if (!ahead_) return std::optional<TimedImage>();
    TimedImage image = std::move(ahead_->image);
    ahead_ = take_usable();
    return std::optional(std::move(image));
  }

  std::size_t left_out() const override {
    return list_.unreadable.count() + missing_.count() + damaged_.count() + resized_.count();
  }

  Problems warnings() const override {
    Problems warnings = list_.warnings;
    list_.unreadable.warn("record", warnings);
    missing_.warn("missing image", warnings);
    damaged_.warn("damaged image", warnings);
    resized_.warn("image", warnings);
    return warnings;
  }

 private:
  std::optional<UsableImage> take_usable() {
    while (at_ < list_.images.size()) {
      const ListedImage& listed = list_.images[at_++];
      std::error_code error;
      if (!std::filesystem::is_regular_file(listed.file, error)) {
        missing_.add({{listed.file.string()}, "no such file"});
      } else if (auto usable = read_usable(listed); !usable) {
        damaged_.add(usable.problems().front());
      } else if (width_px_ != 0 && (usable->width_px != width_px_ || usable->height_px != height_px_)) {
        resized_.add({{listed.file.string()},
                      fmt::format("has {} x {} pixels, the first image {} x {}", usable->width_px,
                                  usable->height_px, width_px_, height_px_)});
      } else {
        return std::move(*usable);
      }
    }
    return std::nullopt;
  }

  Problem nothing_usable() const {
    for (const LeftOut& left_out : {damaged_, missing_, list_.unreadable}) {
      if (left_out.count() > 0)
        return {left_out.first().where, fmt::format("{}; none of the images of {} can be used",
                                                    left_out.first().what, list_.recording.string())};
    }
    return {{list_.recording.string()}, "has no images"};
  }

  ImageList list_;
  double period_s_ = 0;
  int width_px_ = 0;
  int height_px_ = 0;
  std::size_t at_ = 0;
  std::optional<UsableImage> ahead_;
  LeftOut missing_;
  LeftOut damaged_;
  LeftOut resized_;
};

}  // namespace

Result<std::unique_ptr<ImageSequence>> sequence_of(ImageList list) {
  auto sequence = std::make_unique<ListedSequence>(std::move(list));
  if (Problems problems = sequence->begin(); !problems.empty()) return problems;
  return std::unique_ptr<ImageSequence>(std::move(sequence));
}

}  // namespace aisle
