#include <memory>

#include "aisle/commands/check_images.hpp"
#include "aisle/commands/detect.hpp"
#include "examples.hpp"
#include "verb.hpp"

using namespace aisle;

namespace {

template <Feature feature>
void add_feature(CLI::App& detect, Work& work, const std::string& name, const std::string& meaning,
                 std::initializer_list<std::string_view> examples) {
  CLI::App* verb = detect.add_subcommand(name, meaning);
  verb->fallthrough();
  add_examples(*verb, examples);
  auto options = std::make_shared<DetectOptions>();
  options->feature = feature;
  verb->add_option("IMAGE", options->files, "image files: PNG, JPEG, PGM, PPM, BMP, TIFF");
  if (feature != Feature::kPlaces) {
    verb->add_option("--calibration", options->camera,
                     "calibration of the camera (OpenCV YAML or ROS camera_info); optional");
  }
  verb->add_option(
      "-o,--out", options->overlay,
      feature == Feature::kRegion
          ? "output directory for the region masks and for the images with the detections drawn in"
          : "output directory for the images with the detections drawn in");
  if (feature == Feature::kVerticals) {
    verb->add_flag(
        "--follow", options->follow,
        "track lines through the images, which are of one drive and in order: a line keeps its number");
  }
  if (feature == Feature::kPlaces) {
    verb->add_flag(
        "--follow", options->follow,
        "the images are of one drive along the path, in order: consecutive places confirm each other");
    verb->add_option("--taught", options->taught,
                     "images of the taught places, or directories of such images, in order along the path");
  }
  verb->add_flag("--force", options->force, "overwrite existing results");
  add_parameter_options(
      *verb, options->parameters, [] { return detect_parameters(feature); }, work,
      [options, &work] {
        if (options->files.empty()) throw CLI::RequiredError("IMAGE");
        if (feature == Feature::kPlaces && options->taught.empty()) throw CLI::RequiredError("--taught");
        work = [options](Console& console) { return run_detect(*options, console); };
      });
}

/// `detect --check` and what goes with it; without --check a feature is required.
void add_check(CLI::App& detect, Work& work) {
  auto options = std::make_shared<CheckImagesOptions>();
  detect
      .add_option(
          "--check", options->recordings,
          "images, folders of images, a Donkeycar tub, a list of images (CSV), a ROS bag or a session: say "
          "whether each method sees in them what it drives by, and what would help")
      ->type_name("IMAGES");
  detect.add_option("--calibration", options->calibration,
                    "calibration of the camera (OpenCV YAML or ROS camera_info); optional");
  detect.add_option("--topic", options->topic,
                    "topic of a bag's or a session's images (default: the only one)");
  detect.add_option("--images-max", options->images_max, "look at so many, evenly chosen (default 200)")
      ->check(CLI::Range(1, 100000));
  detect.add_option("-o,--out", options->out,
                    "output directory for images with what is seen drawn in, 24 at most");
  detect.add_flag("--force", options->force, "overwrite existing results");
  add_parameter_options(
      detect, options->parameters, check_images_parameters, work, [&detect, options, &work] {
        const bool has_feature = !detect.get_subcommands().empty();
        if (has_feature && !options->recordings.empty())
          throw CLI::ValidationError("--check", "looks at all features: give no verb below detect beside it");
        if (has_feature) return;
        if (options->recordings.empty()) throw CLI::RequiredError("A subcommand or --check IMAGES");
        work = [options](Console& console) { return run_check_images(*options, console); };
      });
}

}  // namespace

void add_detect_verb(CLI::App& app, Work& work) {
  CLI::App* detect = app.add_subcommand("detect", "find features in images");
  detect->fallthrough();
  add_check(*detect, work);
  add_feature<Feature::kVerticals>(
      *detect, work, "verticals",
      "vertical lines of the building, and which of them stand on a wall-floor edge",
      {"aisle detect verticals view.png --calibration camera.yaml",
       "aisle detect verticals frame-1.png frame-2.png --follow --out out/lines"});
  add_feature<Feature::kBaseLines>(
      *detect, work, "baselines", "wall-floor edges of the right and the left wall of a corridor",
      {"aisle detect baselines view.png",
       "aisle detect baselines view.png --calibration camera.yaml --out out/edges"});
  add_feature<Feature::kStripes>(
      *detect, work, "stripes", "stripes of a horizontal laser plane, as polylines with their corners",
      {"aisle detect stripes view.png",
       "aisle detect stripes view.png --calibration camera.yaml --out out/stripes"});
  add_feature<Feature::kRegion>(
      *detect, work, "region", "free floor in front of the vehicle, as a mask",
      {"aisle detect region view.png", "aisle detect region view.png --out out/region"});
  add_feature<Feature::kPlaces>(
      *detect, work, "places", "taught places at which the images were taken",
      {"aisle detect places view.png --taught place-1.png place-2.png",
       "aisle detect places frame-1.png frame-2.png --follow --taught places --out out/places"});
  add_examples(*detect, {"aisle detect verticals view.png --out out/lines",
                         "aisle detect places view.png --taught places",
                         "aisle detect --check frames --out out/check"});
}
