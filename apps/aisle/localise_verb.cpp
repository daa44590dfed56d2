#include <memory>

#include "aisle/commands/localise.hpp"
#include "examples.hpp"
#include "option_kinds.hpp"
#include "verb.hpp"

using namespace aisle;

void add_localise_verb(CLI::App& app, Work& work) {
  CLI::App* verb =
      app.add_subcommand("localise", "find the vehicle of a recorded laser log in a known building");
  auto options = std::make_shared<LocaliseOptions>();
  verb->fallthrough();
  add_examples(*verb, {"aisle localise drive.bag --building out/office/building.json",
                       "aisle localise drive.clf --building map.yaml --at 1,2,90 --out poses.tum"});
  verb->add_option("LOG", options->log,
                   "recording of a 2-D laser scanner: CARMEN log, MRPT rawlog, CSV, ROS bag");
  verb->add_option("--building", options->building,
                   "building file (JSON), or a map of map_server (YAML) or Bee");
  verb->add_option_function<std::string>(
      "--at", [options](const std::string& text) { options->T_map_hint = parse_place("--at", text); },
      "where the recording begins, x,y,heading_deg in the map: a hint that is checked (default: anywhere)");
  add_reading_options(*verb, options->reading);
  verb->add_option("--relations", options->relations,
                   "file of known relative poses, to measure the error against");
  verb->add_option("-o,--out", options->out, "TUM file of the poses at which it was found");
  verb->add_flag("--force", options->force, "overwrite an existing file");
  add_parameter_options(*verb, options->parameters, localise_parameters, work, [options, &work] {
    if (options->log.empty()) throw CLI::RequiredError("LOG");
    if (options->building.empty()) throw CLI::RequiredError("--building");
    work = [options](Console& console) { return run_localise(*options, console); };
  });
}
