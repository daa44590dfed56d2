#include <memory>

#include "aisle/commands/drive.hpp"
#include "examples.hpp"
#include "live_options.hpp"
#include "operator_options.hpp"
#include "option_kinds.hpp"
#include "vehicle_options.hpp"
#include "verb.hpp"

using namespace aisle;

void add_drive_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand("drive", "drive a simulated vehicle or a robot by hand");
  verb->fallthrough();
  add_examples(*verb, {"aisle drive l-corridor --operator scripted --out out/run",
                       "aisle drive l-corridor --faults camera-frozen --keys keys.txt",
                       "aisle drive --connect robot.yaml --operator joystick --out out/run"});
  auto options = std::make_shared<DriveOptions>();
  auto operator_options = std::make_shared<OperatorOptions>();
  auto no_images = std::make_shared<bool>(false);
  verb->add_option("WORLD", options->world, "world file (YAML) or name of a shipped world");
  verb->add_option("--vehicle", options->vehicle,
                   "vehicle file (YAML) or name of a shipped vehicle (default alv)");
  verb->add_option(
      "--faults", options->scenario,
      "scenario file (YAML) of faults to inject, or name of a shipped scenario (default: no faults)");
  add_seed(*verb, options->seed, "random seed; the same seed gives the same session (default 1)");
  verb->add_option("-o,--out", options->out, "output directory for the session");
  verb->add_flag("--force", options->force, "overwrite an existing session");
  add_storage(*verb, options->storage);
  add_operator_options(*verb, *operator_options);
  const LiveOption live(*verb);
  verb->add_flag("--no-images", *no_images, "do not render camera images (faster)");
  add_robot(*verb, options->connection, {"WORLD", "--vehicle", "--faults", "--seed", "--no-images"});
  add_parameter_options(*verb, options->parameters, drive_parameters, work, [=, &app, &work] {
    require_vehicle(options->world, options->connection);
    check_driver(*operator_options, live, *options);
    options->takes_images = !*no_images;
    options->keys = key_operator(*operator_options, app.count("--quiet") > 0);
    work = live.around([options, operator_options](Console& console, const DriveOptions::KeyOperator& hand) {
      DriveOptions driven = *options;
      if (operator_options->kind == OperatorKind::kPage) driven.keys = hand;
      return run_drive(driven, console);
    });
  });
}
