#include <memory>

#include "aisle/commands/detect.hpp"
#include "verb.hpp"

using namespace aisle;

namespace {

template <Feature feature>
void add_feature(CLI::App& detect, Work& work, const std::string& name, const std::string& meaning) {
  CLI::App* verb = detect.add_subcommand(name, meaning);
  verb->fallthrough();
  auto options = std::make_shared<DetectOptions>();
  options->feature = feature;
  verb->add_option("IMAGE", options->files, "images: PNG, JPEG, PGM, PPM, BMP, TIFF");
  if (feature != Feature::kPlaces) {
    verb->add_option(
        "--camera", options->camera,
        "its calibration, OpenCV YAML or ROS camera_info; all features are found without it too");
  }
  verb->add_option("--overlay", options->overlay,
                   feature == Feature::kRegion
                       ? "directory for the region masks and for the images with what was found drawn over"
                       : "directory for the images with what was found drawn over");
  if (feature == Feature::kVerticals) {
    verb->add_flag("--follow", options->follow,
                   "the images are of one drive, in order: the same line has the same number in all of them");
  }
  if (feature == Feature::kPlaces) {
    verb->add_flag("--follow", options->follow,
                   "the images are of one drive along the path, in order: places that go on along it confirm "
                   "each other");
    verb->add_option("--taught", options->taught,
                     "images of the taught places, or directories of them, in order along the path");
  }
  verb->add_flag("--force", options->force, "replace results that are there already");
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
  add_feature<Feature::kVerticals>(*detect, work, "verticals",
                                   "lines that are vertical in the building, and which stand on a base line");
  add_feature<Feature::kBaseLines>(*detect, work, "baselines",
                                   "where the right and the left wall of a corridor meet the floor");
  add_feature<Feature::kStripes>(*detect, work, "stripes",
                                 "the marks of a horizontal laser plane, as polylines with their corners");
  add_feature<Feature::kRegion>(*detect, work, "region", "the floor in front of the vehicle, as a mask");
  add_feature<Feature::kPlaces>(*detect, work, "places", "the taught places at which the images were taken");
}
