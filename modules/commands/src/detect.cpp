#include "aisle/commands/detect.hpp"

#include <fmt/format.h>

#include <set>

#include "aisle/commands/output_directory.hpp"
#include "aisle/commands/parameter_listing.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/formats/calibration_file.hpp"
#include "aisle/formats/images/image_file.hpp"
#include "detection/image_detector.hpp"
#include "detection/line_pursuit.hpp"

namespace aisle {

nlohmann::ordered_json pixel_json(const Vec2& pixel) {
  return {rounded(pixel.x(), 3), rounded(pixel.y(), 3)};
}

nlohmann::ordered_json polyline_json(const std::vector<Vec2>& pixels) {
  auto json = nlohmann::ordered_json::array();
  for (const Vec2& pixel : pixels) json.push_back(pixel_json(pixel));
  return json;
}

namespace {

namespace fs = std::filesystem;

constexpr const char* kOverlayEnding = ".overlay.png";
constexpr const char* kMaskEnding = ".region.png";
constexpr const char* kFollowedName = "followed.png";

std::unique_ptr<ImageDetector> make_detector(Feature feature, const std::optional<CameraModel>& camera = {},
                                             std::vector<TaughtImage> taught = {}) {
  switch (feature) {
    case Feature::kVerticals:
      return make_verticals_detector(camera);
    case Feature::kBaseLines:
      return make_base_lines_detector(camera);
    case Feature::kStripes:
      return make_stripe_detector();
    case Feature::kRegion:
      return make_region_detector();
    case Feature::kPlaces:
      return make_places_detector(std::move(taught));
  }
  throw std::invalid_argument("no such feature");
}

FieldList fields_of(ImageDetector& detector, Feature feature, LineFollowerParams& following) {
  FieldList fields = fields_of(detector);
  if (feature == Feature::kVerticals) fields.group("follow", following);
  return fields;
}

const char* name_of(Feature feature) {
  switch (feature) {
    case Feature::kVerticals:
      return "detect verticals";
    case Feature::kBaseLines:
      return "detect baselines";
    case Feature::kStripes:
      return "detect stripes";
    case Feature::kRegion:
      return "detect region";
    case Feature::kPlaces:
      return "detect places";
  }
  throw std::invalid_argument("no such feature");
}

/// A name for each image's results: its own without the extension, with a number if two are the same.
std::vector<std::string> result_names(const std::vector<std::string>& files) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (const std::string& file : files) {
    const std::string stem = fs::path(file).stem().string();
    std::string name = stem;
    for (int number = 2; !taken.insert(name).second; ++number) name = fmt::format("{}-{}", stem, number);
    names.push_back(name);
  }
  return names;
}

/// Reads an image; if a camera is given, an image of another size is a problem.
Result<Image> read_image_of(const std::optional<CameraCalibration>& camera, const std::string& file) {
  auto image = read_image(file);
  if (!image || !camera || camera->width_px == 0) return image;
  if (image->width_px == camera->width_px && image->height_px == camera->height_px) return image;
  return Problem{{file},
                 fmt::format("has {} x {} pixels; the camera's calibration is for {} x {}", image->width_px,
                             image->height_px, camera->width_px, camera->height_px)};
}

/// Writes all drawings into the overlay directory. @return role -> path
Result<std::map<std::string, std::string>> write(const std::vector<OutputFile>& drawings,
                                                 const DetectOptions& options) {
  std::vector<std::string> names;
  names.reserve(drawings.size());
  for (const OutputFile& drawing : drawings) names.push_back(drawing.name);
  const auto directory = OutputDirectory::open(*options.overlay, options.force, names);
  if (!directory) return directory.problems();
  return directory->write(drawings);
}

}  // namespace

Outcome detect_parameters(Feature feature) {
  const auto detector = make_detector(feature);
  LineFollowerParams following;
  return parameter_listing(name_of(feature), fields_of(*detector, feature, following));
}

Result<Outcome> run_detect(const DetectOptions& options, Console& console) {
  std::optional<CameraCalibration> calibration;
  std::optional<CameraModel> camera;
  if (options.camera) {
    const auto read = read_calibration(*options.camera);
    if (!read) return read.problems();
    calibration = *read;
    camera.emplace(calibration->intrinsics);
  }
  auto taught = read_taught_images(options.taught);
  if (!taught) return taught.problems();
  const auto detector = make_detector(options.feature, camera, std::move(*taught));
  LineFollowerParams following;
  FieldList fields = fields_of(*detector, options.feature, following);
  if (const Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  const std::vector<std::string> names = result_names(options.files);

  Outcome outcome{.verb = name_of(options.feature)};
  auto& images = outcome.figures["images"] = nlohmann::ordered_json::array();
  std::optional<LinePursuit> pursuit;
  if (options.follow && options.feature == Feature::kVerticals)
    pursuit.emplace(following, options.files.size());
  std::vector<OutputFile> drawings;
  Problems problems;
  for (std::size_t i = 0; i < options.files.size(); ++i) {
    console.progress.report("images", i, options.files.size());
    const auto image = read_image_of(calibration, options.files[i]);
    if (!image) {
      problems.insert(problems.end(), image.problems().begin(), image.problems().end());
      continue;
    }
    Detection found = detector->detect(*image, options.overlay.has_value());
    nlohmann::ordered_json& figures = images.emplace_back();
    figures = {{"file", options.files[i]}, {"width_px", image->width_px}, {"height_px", image->height_px}};
    figures.update(found.figures);
    if (pursuit) pursuit->add(*image, found.verticals, figures["verticals"]);
    if (found.mask_png) figures["region_mask"] = nullptr;
    outcome.text += fmt::format("{}: {}\n", options.files[i], found.summary);
    if (!options.overlay) continue;
    const std::string overlay = names[i] + kOverlayEnding, mask = names[i] + kMaskEnding;
    drawings.push_back({overlay, overlay, std::move(found.overlay_png)});
    if (!found.mask_png) continue;
    figures["region_mask"] = (*options.overlay / mask).string();
    drawings.push_back({mask, mask, std::move(*found.mask_png)});
  }
  if (!problems.empty()) return problems;
  if (options.follow) outcome.text += detector->look_back(images);
  if (pursuit) {
    outcome.figures["follow"] = pursuit->figures();
    outcome.text += pursuit->summary();
  }
  if (!options.overlay) return outcome;
  if (pursuit) drawings.push_back({kFollowedName, kFollowedName, pursuit->sheet_png()});
  const auto written = write(drawings, options);
  if (!written) return written.problems();
  outcome.files = *written;
  outcome.text += fmt::format("{} files in {}\n", drawings.size(), options.overlay->string());
  return outcome;
}

}  // namespace aisle
