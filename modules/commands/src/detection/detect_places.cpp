#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "aisle/core/rounded.hpp"
#include "aisle/formats/images/image_file.hpp"
#include "aisle/report/picture_sheet.hpp"
#include "aisle/vision/places/place_recogniser.hpp"
#include "detection/image_detector.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kUnlikeDecimals = 4;

/// Names the taught image whose place an image was taken at.
class PlacesDetector final : public ImageDetector {
 public:
  explicit PlacesDetector(std::vector<TaughtImage> taught) : taught_(std::move(taught)) {}

  void describe(FieldList& fields) override { fields.group("places", params_); }

  Detection detect(const Image& image, bool is_drawn) override {
    if (!recogniser_) {
      recogniser_.emplace(params_);
      for (const TaughtImage& taught : taught_) recogniser_->teach(taught.image);
    }
    const ViewRecognition found = recogniser_->recognise(image).value();
    const TaughtImage& alike = taught_[found.view];
    const bool is_sure = recogniser_->is_sure(found);
    Detection detection;
    detection.figures = {{"place", is_sure ? Json(alike.name) : Json(nullptr)},
                         {"most_alike", alike.name},
                         {"unlike", rounded(found.unlike, kUnlikeDecimals)},
                         {"rival_unlike", std::isfinite(found.rival_unlike)
                                              ? Json(rounded(found.rival_unlike, kUnlikeDecimals))
                                              : Json(nullptr)}};
    detection.summary = fmt::format("{} {}", is_sure ? "taken at" : "unsure; most like", alike.name);
    places_.push_back(found.view);
    if (is_drawn) {
      const std::array<TakenPicture, 2> pair = {TakenPicture{image, "is most like"},
                                                TakenPicture{alike.image, alike.name}};
      detection.overlay_png = picture_sheet_png(pair);
    }
    return detection;
  }

  std::string look_back(Json& images) override {
    const std::vector<bool> confirmed = recogniser_->confirmed(places_);
    std::size_t known = 0;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (confirmed[i]) images[i]["place"] = images[i]["most_alike"];
      known += static_cast<std::size_t>(!images[i]["place"].is_null());
    }
    return fmt::format(
        "including places that confirm each other, {} of {} images were taken at taught places\n", known,
        places_.size());
  }

 private:
  PlaceParams params_;
  std::vector<TaughtImage> taught_;
  std::optional<PlaceRecogniser> recogniser_;  // made once the parameters are known
  std::vector<std::size_t> places_;            // most similar taught image of each image so far
};

bool is_image(const fs::path& path) {
  constexpr std::array<std::string_view, 8> kEndings = {".png", ".jpg", ".jpeg", ".pgm",
                                                        ".ppm", ".bmp", ".tif",  ".tiff"};
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

/// The images of a directory, in the order of the numbers in their names.
Result<std::vector<fs::path>> images_at(const fs::path& path) {
  if (!fs::is_directory(path)) return std::vector{path};
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(path, error), end; !error && entry != end; entry.increment(error))
    if (is_image(entry->path())) files.push_back(entry->path());
  if (error) return Problem{{path.string()}, fmt::format("cannot be read: {}", error.message())};
  if (files.empty()) return Problem{{path.string()}, "has no images"};
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return strverscmp(a.filename().c_str(), b.filename().c_str()) < 0;
  });
  return files;
}

}  // namespace

Result<std::vector<TaughtImage>> read_taught_images(const std::vector<fs::path>& paths) {
  std::vector<TaughtImage> taught;
  Problems problems;
  const auto note = [&](const Problems& more) { problems.insert(problems.end(), more.begin(), more.end()); };
  for (const fs::path& path : paths) {
    const auto files = images_at(path);
    if (!files) {
      note(files.problems());
      continue;
    }
    for (const fs::path& file : *files) {
      auto image = read_image(file);
      if (!image)
        note(image.problems());
      else
        taught.push_back({file.string(), std::move(*image)});
    }
  }
  if (!problems.empty()) return problems;
  return taught;
}

std::unique_ptr<ImageDetector> make_places_detector(std::vector<TaughtImage> taught) {
  return std::make_unique<PlacesDetector>(std::move(taught));
}

}  // namespace aisle
