#include "detection/checked_images.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "aisle/formats/bags/bag_reader.hpp"
#include "aisle/formats/images/image_file.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;

constexpr double kAnyRate_hz = 10;  // stamps do not matter here, and a list may have none

bool is_image_file(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) return false;
  constexpr std::array kEndings = {".png", ".jpg", ".jpeg", ".pgm",  ".ppm",
                                   ".pbm", ".bmp", ".tif",  ".tiff", ".webp"};
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

}  // namespace

std::vector<bool> evenly_chosen(std::size_t all, std::size_t most) {
  std::vector<bool> chosen(all, all <= most);
  if (all <= most) return chosen;
  const std::size_t pairs = std::max<std::size_t>(1, most / 2);
  for (std::size_t k = 0; k < pairs; ++k) {
    const std::size_t first = k * all / pairs;
    chosen[first] = true;
    if (most > 1 && first + 1 < all) chosen[first + 1] = true;
  }
  return chosen;
}

Result<CheckedImages::Source> CheckedImages::source_of(const std::string& recording,
                                                       const CheckImagesOptions& options) {
  Source source{.name = recording};
  std::error_code error;
  if (fs::exists(recording, error) && is_image_file(recording)) {
    source.files = {recording};
    source.is_named = true;
    return source;
  }
  source.files = images_in_folder(recording);
  if (!source.files.empty()) return source;
  ImageSequenceOptions reading{.topic = options.topic};
  if (!is_bag(recording)) reading.rate_hz = kAnyRate_hz;
  auto sequence = open_image_sequence(recording, reading);
  if (!sequence) return sequence.problems();
  source.sequence = std::move(*sequence);
  return source;
}

Result<CheckedImages> CheckedImages::open(const CheckImagesOptions& options) {
  CheckedImages images;
  Problems problems;
  std::size_t all = 0;
  for (const std::string& recording : options.recordings) {
    auto source = source_of(recording, options);
    if (!source) {
      problems.insert(problems.end(), source.problems().begin(), source.problems().end());
      continue;
    }
    all += source->size();
    images.sources_.push_back(std::move(*source));
  }
  if (!problems.empty()) return problems;
  images.wanted_ = evenly_chosen(all, static_cast<std::size_t>(options.images_max));
  return images;
}

std::size_t CheckedImages::wanted() const {
  return static_cast<std::size_t>(std::count(wanted_.begin(), wanted_.end(), true));
}

std::optional<CameraIntrinsics> CheckedImages::lens() const {
  if (sources_.size() != 1 || !sources_[0].sequence) return std::nullopt;
  return sources_[0].sequence->camera().lens;
}

Result<std::optional<CheckedImage>> CheckedImages::next() {
  while (source_ < sources_.size()) {
    Source& source = sources_[source_];
    auto image = next_of(source);
    if (!image) return image.problems();
    if (*image) return image;
    passed_ += source.size() - in_source_;
    in_source_ = 0;
    ++source_;
    last_.reset();
  }
  return std::optional<CheckedImage>();
}

Result<std::optional<CheckedImage>> CheckedImages::next_of(Source& source) {
  while (in_source_ < source.size()) {
    const std::size_t number = passed_, in_source = in_source_;
    CheckedImage checked;
    std::optional<TimedImage> taken;
    if (source.sequence) {
      auto next = source.sequence->next();
      if (!next) return next.problems();
      if (!*next) return std::optional<CheckedImage>();
      taken = std::move(*next);
    }
    ++passed_;
    ++in_source_;
    if (!wanted_[number]) continue;
    checked.name =
        source.sequence ? fmt::format("{}#{}", source.name, in_source) : source.files[in_source].string();
    auto image = taken ? parse_image(taken->bytes, checked.name) : read_image(source.files[in_source]);
    if (!image) {
      if (source.is_named) return image.problems();
      leave_out(image.problems());
      continue;
    }
    checked.image = std::move(*image);
    checked.is_next = last_ && *last_ + 1 == number;
    last_ = number;
    return std::optional(std::move(checked));
  }
  return std::optional<CheckedImage>();
}

void CheckedImages::leave_out(const Problems& why) {
  if (++unreadable_ == 1) first_unreadable_ = why;
}

std::size_t CheckedImages::left_out() const {
  std::size_t count = unreadable_;
  for (const Source& source : sources_)
    if (source.sequence) count += source.sequence->left_out();
  return count;
}

Problems CheckedImages::warnings() const {
  Problems warnings;
  for (const Problem& problem : first_unreadable_)
    warnings.push_back(
        {problem.where, fmt::format("{}; {} such images left out", problem.what, unreadable_)});
  return warnings;
}

}  // namespace aisle
