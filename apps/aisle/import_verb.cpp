#include <memory>

#include "aisle/commands/import_recording.hpp"
#include "examples.hpp"
#include "option_kinds.hpp"
#include "verb.hpp"

using namespace aisle;

void add_import_verb(CLI::App& app, Work& work) {
  CLI::App* verb =
      app.add_subcommand("import", "make a session of a recording made elsewhere: images, scans");
  verb->fallthrough();
  add_examples(*verb, {"aisle import frames --image-rate 10 --vehicle alv -o out/imported",
                       "aisle import drive.bag --camera /camera/image_raw/compressed -o out/imported"});
  auto options = std::make_shared<ImportOptions>();
  verb->add_option("INPUT", options->recording,
                   "folder of a Donkeycar tub, list of images (CSV), folder of images, ROS bag, or laser log")
      ->required();
  verb->add_option("-o,--out", options->out, "directory of the new session")->required();
  verb->add_option("--image-rate", options->rate_hz,
                   "images per second, in the place of the recording's stamps (default: its stamps)")
      ->type_name("HZ")
      ->check(CLI::Range(0.01, 1000.0));
  verb->add_option(
      "--vehicle", options->vehicle,
      "vehicle that took the images: file (YAML) or name of a shipped vehicle (default: unknown, "
      "so nothing can be measured in the images)");
  verb->add_option("--camera", options->camera,
                   "topic of a bag's images (default: the only one), else name of the camera (default: the "
                   "vehicle's, or front)");
  add_reading_options(*verb, options->reading);
  verb->add_flag("--force", options->force, "overwrite an existing session");
  add_storage(*verb, options->storage);
  verb->callback(
      [options, &work] { work = [options](Console& console) { return run_import(*options, console); }; });
}
