#include "aisle/commands/check_images.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "aisle/commands/output_directory.hpp"
#include "aisle/commands/parameter_listing.hpp"
#include "aisle/formats/calibration_file.hpp"
#include "aisle/report/detection_overlay.hpp"
#include "detection/check_words.hpp"
#include "detection/checked_images.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kCheckVerb = "detect check";
constexpr std::size_t kOverlaysMax = 24;  // more are looked at by nobody

/// The lens: as the user says, else as a recording does.
Result<std::optional<CameraIntrinsics>> lens_of(const CheckImagesOptions& options,
                                                const CheckedImages& images,
                                                std::optional<CameraCalibration>& calibration) {
  if (!options.calibration) return images.lens();
  auto read = read_calibration(*options.calibration);
  if (!read) return read.problems();
  calibration = std::move(*read);
  return std::optional(calibration->intrinsics);
}

Problems size_problems(const CheckedImage& checked, const std::optional<CameraCalibration>& calibration) {
  if (!calibration || calibration->width_px == 0) return {};
  const Image& image = checked.image;
  if (image.width_px == calibration->width_px && image.height_px == calibration->height_px) return {};
  return {{{checked.name},
           fmt::format("has {} x {} pixels; the camera's calibration is for {} x {}", image.width_px,
                       image.height_px, calibration->width_px, calibration->height_px)}};
}

/// A file name for each overlay: the image's own name, with a number if two are the same.
class OverlayNames {
 public:
  std::string name_of(const std::string& image) {
    std::string stem = image.find('#') == std::string::npos ? fs::path(image).stem().string()
                                                            : "image-" + image.substr(image.rfind('#') + 1);
    const int number = ++taken_[stem];
    if (number > 1) stem += fmt::format("-{}", number);
    return stem + ".overlay.png";
  }

 private:
  std::map<std::string, int> taken_;
};

/// Everything that is found in the images, one after the other.
struct Findings {
  std::vector<std::string> names;
  std::vector<ImageEvidence> evidence;
  std::vector<PairEvidence> pairs;
  std::vector<OutputFile> overlays;
};

Result<Findings> look_at_all(CheckedImages& images, const CheckImagesOptions& options,
                             const std::optional<CameraIntrinsics>& lens,
                             const std::optional<CameraCalibration>& calibration, Console& console) {
  Findings findings;
  ImageExaminer examiner(lens);
  PairExaminer pair_examiner;
  OverlayNames names;
  const std::vector<bool> is_drawn = evenly_chosen(images.wanted(), kOverlaysMax);
  while (true) {
    console.progress.report("checking", images.passed(), images.size());
    const auto next = images.next();
    if (!next) return next.problems();
    if (!*next) return findings;
    const CheckedImage& checked = **next;
    if (Problems problems = size_problems(checked, calibration); !problems.empty()) return problems;
    findings.names.push_back(checked.name);
    findings.evidence.push_back(examiner.examine(checked.image));
    if (!checked.is_next) pair_examiner.forget();
    if (const auto pair = pair_examiner.take(checked.image, examiner.lines(), examiner.floor()))
      findings.pairs.push_back(*pair);
    if (!options.out || !is_drawn[findings.names.size() - 1]) continue;
    const std::string name = names.name_of(checked.name);
    findings.overlays.push_back(
        {name, name, features_overlay_png(checked.image, examiner.lines(), examiner.floor())});
  }
}

/// By the row of the corridor's end, which is as far away as the horizon.
std::optional<double> tilt_of(const ViewMedians& medians, const std::optional<CameraIntrinsics>& lens) {
  if (!lens || !medians.horizon) return std::nullopt;
  const auto ray = CameraModel(*lens).ray({lens->cx_px, *medians.horizon * medians.height_px});
  if (!ray) return std::nullopt;
  return std::atan(-ray->direction.y());
}

}  // namespace

Outcome check_images_parameters() {
  ViewCheckParams params;
  FieldList fields;
  fields.group("check", params);
  return parameter_listing(kCheckVerb, fields);
}

Result<Outcome> run_check_images(const CheckImagesOptions& options, Console& console) {
  ViewCheckParams params;
  FieldList fields;
  fields.group("check", params);
  if (const Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  std::optional<OutputDirectory> reserved;  // a bad path is told before the work
  if (options.out) {
    auto opened = OutputDirectory::open(*options.out, options.force, {});
    if (!opened) return opened.problems();
    reserved.emplace(std::move(*opened));
  }
  auto images = CheckedImages::open(options);
  if (!images) return images.problems();
  std::optional<CameraCalibration> calibration;
  const auto lens = lens_of(options, *images, calibration);
  if (!lens) return lens.problems();
  auto findings = look_at_all(*images, options, *lens, calibration, console);
  if (!findings) return findings.problems();
  if (findings->evidence.empty()) {
    Problems problems = images->warnings();
    problems.push_back(
        {{options.recordings.front()}, "has no image that can be read: give PNG or JPEG images"});
    return problems;
  }
  warn_of(images->warnings(), console);

  const ViewCheck check = check_views(findings->evidence, findings->pairs, lens->has_value(), params);
  const CheckScope scope{.found = images->size(),
                         .checked = findings->names.size(),
                         .left_out = images->left_out(),
                         .is_lens_known = lens->has_value(),
                         .tilt_rad = tilt_of(check.medians, *lens)};
  Outcome outcome{.verb = kCheckVerb};
  outcome.figures = view_check_json(check, scope);
  Json& listed = outcome.figures["images"] = Json::array();
  for (std::size_t i = 0; i < findings->names.size(); ++i) {
    Json& figures = listed.emplace_back(Json{{"file", findings->names[i]}});
    figures.update(evidence_json(findings->evidence[i], check.views[i]));
  }
  outcome.text = view_check_text(check, scope);
  if (!options.out) return outcome;
  std::vector<std::string> names;
  for (const OutputFile& overlay : findings->overlays) names.push_back(overlay.name);
  const auto directory = OutputDirectory::open(*options.out, options.force, names);
  if (!directory) return directory.problems();
  const auto written = directory->write(findings->overlays);
  if (!written) return written.problems();
  outcome.files = *written;
  outcome.text += fmt::format("\nsee {} ({} of the images)\n", options.out->string(), names.size());
  return outcome;
}

}  // namespace aisle
