#include <memory>
#include <vector>

#include "aisle/commands/explore.hpp"
#include "aisle/core/angle.hpp"
#include "live_options.hpp"
#include "option_kinds.hpp"
#include "verb.hpp"

using namespace aisle;

void add_explore_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand("explore", "learn a building that nobody has shown, and come home");
  verb->fallthrough();
  auto options = std::make_shared<ExploreOptions>();
  auto start = std::make_shared<std::vector<double>>();
  verb->add_option("WORLD", options->world, "world file (YAML), or the name of a shipped one");
  verb->add_option("--vehicle", options->vehicle,
                   "vehicle file (YAML), or the name of a shipped one (default: the one with the sensor)");
  add_choice<ExploringSensor>(
      *verb, "--sensor", options->sensor,
      {{"scanner", ExploringSensor::kScanner}, {"markers", ExploringSensor::kMarkers}},
      "what shows it its surroundings (default scanner)");
  verb->add_option("--faults", options->scenario,
                   "scenario file (YAML) of what goes wrong, or the name of a shipped one");
  add_choice<ExploringOrder>(*verb, "--order", options->order,
                             {{"recommended", ExploringOrder::kRecommended},
                              {"published", ExploringOrder::kPublished},
                              {"nearest-frontier", ExploringOrder::kNearest}},
                             "in which order paths are taken (default recommended)");
  verb->add_option("--start", *start, "x,y,heading_deg where the vehicle is set down (default: the world's)")
      ->delimiter(',')
      ->expected(3);
  verb->add_flag("--compare", options->compares, "drive by nearest frontier as well, and tell both ways");
  add_seed(*verb, options->seed, "of all noise; the same seed gives the same trip (default 1)");
  verb->add_option("--out", options->out, "directory for building.json, the pictures and report.html");
  verb->add_option("--session", options->session, "directory to record the trip in, as a session");
  verb->add_option("--resume", options->resumed,
                   "session of a trip that was interrupted: it goes on from where it stood");
  verb->add_flag("--force", options->force, "replace results that are there already");
  const LiveOption live(*verb);
  add_parameter_options(*verb, options->parameters, explore_parameters, work, [=, &work] {
    if (options->world.empty()) throw CLI::RequiredError("WORLD");
    if (start->size() == 3)
      options->T_world_start = Pose2{(*start)[0], (*start)[1], wrap_angle((*start)[2] * kDegree)};
    work = live.around([options](Console& console, const auto&) { return run_explore(*options, console); });
  });
}
