#include <memory>

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

}  // namespace

void add_detect_verb(CLI::App& app, Work& work) {
  CLI::App* detect = app.add_subcommand("detect", "find features in images");
  detect->require_subcommand(1);
  detect->fallthrough();
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
                         "aisle detect places view.png --taught places"});
}
