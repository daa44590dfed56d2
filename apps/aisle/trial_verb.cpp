#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/commands/method.hpp"
#include "aisle/trials/trial.hpp"
#include "examples.hpp"
#include "option_kinds.hpp"
#include "parking_choices.hpp"
#include "trial_verb.hpp"
#include "verb.hpp"

using namespace aisle;

namespace {

/// "A..B" or "A".
bool read_seeds(const std::string& text, std::uint64_t& first, std::uint64_t& last) {
  constexpr std::uint64_t kSeedsMax = 1'000'000;
  const auto read = [](std::string_view digits, std::uint64_t& value) {
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return error == std::errc() && end == digits.data() + digits.size();
  };
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos) return read(text, first) && read(text, last);
  return read(std::string_view(text).substr(0, dots), first) &&
         read(std::string_view(text).substr(dots + 2), last) && first <= last && last - first < kSeedsMax;
}

/// What was given to the verb, but for these options.
std::vector<std::string> words_of(const CLI::App& verb, const std::set<const CLI::Option*>& without) {
  std::vector<std::string> words;
  for (const CLI::Option* option : verb.get_options()) {
    if (option->count() == 0 || without.contains(option)) continue;
    if (!option->get_positional()) words.push_back(option->get_name());
    if (option->get_expected_min() == 0 && !option->get_positional()) continue;
    for (const std::string& word : option->results()) words.push_back(word);
  }
  return words;
}

/// An option that not every method uses.
struct MethodOption {
  std::string option;
  std::vector<std::string_view> methods;  ///< that use it

  bool is_used_by(std::string_view method) const {
    return std::find(methods.begin(), methods.end(), method) != methods.end();
  }
};

const std::vector<MethodOption>& method_options() {
  static const std::vector<MethodOption> options = {
      {"--world", {"landmarks", "sections", "rooms", "park", "explore", "localise"}},
      {"--resolution", {"landmarks", "sections", "explore", "localise"}},
      {"--kind", {"landmarks", "sections", "explore", "localise"}},
      {"--sensor", {"explore"}},
      {"--speed", {"landmarks", "sections", "rooms", "turnings", "park"}},
      {"--strategy", {"park"}},
      {"--teachings", {"sections"}},
      {"--refinements", {"landmarks"}},
      {"--noise-scale", {"explore"}},
      {"--start-anywhere", {"explore"}},
      {"--lift", {"landmarks"}},
      {"--reverse", {"landmarks", "park"}},
      {"--outdated-map", {"localise"}},
      {"--close", {"turnings"}}};
  return options;
}

/// The help of each such option begins with the methods that use it.
void name_methods_in_help(CLI::App& verb) {
  for (const MethodOption& one : method_options()) {
    CLI::Option* option = verb.get_option(one.option);
    option->description(fmt::format("{}: {}", fmt::join(one.methods, ", "), option->get_description()));
  }
}

/// Throws for an option that the method would ignore. A method that is none is left to the trial.
void refuse_unused_options(const CLI::App& verb, const std::string& method) {
  const std::vector<std::string_view> methods = trial_methods();
  if (std::find(methods.begin(), methods.end(), method) == methods.end()) return;
  for (const MethodOption& one : method_options()) {
    if (verb.get_option(one.option)->count() == 0 || one.is_used_by(method)) continue;
    throw CLI::ValidationError(
        one.option, fmt::format("is not used by {}, only by {}", method, fmt::join(one.methods, ", ")));
  }
}

}  // namespace

const CLI::Option* add_jobs(CLI::App& verb, int& jobs) {
  return verb
      .add_option("--jobs", jobs,
                  "missions that run at a time (default: as many as there are cores; under mpirun 1 in each "
                  "process)")
      ->check(CLI::Range(1, 1024));
}

void add_trial_verb(CLI::App& app, Work& work) {
  add_trial_verb(app, work, [&work](const TrialOptions& options) {
    work = [options](Console& console) { return run_trial(options, console); };
  });
}

void add_trial_verb(CLI::App& app, Work& work, const std::function<void(const TrialOptions&)>& chosen) {
  CLI::App* verb = app.add_subcommand(
      "trial", "run complete simulated missions, one per seed, and print their statistics");
  verb->fallthrough();
  add_examples(*verb, {"aisle trial explore --seeds 1..20 --kind office --out out/trials",
                       "aisle trial landmarks --seeds 1..10 --world l-corridor --faults camera-frozen",
                       "aisle trial park --strategy frame --seeds 7"});
  auto options = std::make_shared<TrialOptions>();
  options->method.clear();
  verb->add_option("METHOD", options->method,
                   fmt::format("what to try: {}", fmt::join(trial_methods(), ", ")));
  const CLI::Option* seeds = verb->add_option_function<std::string>(
      "--seeds",
      [options](const std::string& text) {
        if (!read_seeds(text, options->first_seed, options->last_seed))
          throw CLI::ValidationError("--seeds", "'" + text + "' is neither a seed nor a range like 1..20");
      },
      "seed of the mission, or a range of seeds like 1..20 (default 1)");
  verb->add_option(
      "--world", options->worlds,
      "world files (YAML), names of shipped worlds, or floor plans that 'aisle convert' reads; taken in "
      "turn (default: random buildings)");
  add_resolution(*verb, options->plan_pixel_m);
  add_exploring_sensor(*verb, options->sensor, "sensor to explore with (default scanner)");
  verb->add_option("--vehicle", options->vehicle,
                   "vehicle file (YAML) or name of a shipped vehicle (default alv; mini for sections; "
                   "alv-scanner for explore with the scanner)");
  verb->add_option(
      "--faults", options->scenario,
      "scenario file (YAML) of faults to inject while driving autonomously, or name of a shipped "
      "scenario (default: no faults)");
  add_choice<ParkingStrategy>(*verb, "--strategy", options->strategy, parking_choices<ParkingStrategy>(),
                              "parking strategy at the end of the routes (default frame)");
  verb->add_option("--teachings", options->teachings,
                   "number of taught runs before the route is driven autonomously (default 1)")
      ->check(CLI::Range(1, 20));
  verb->add_option("--refinements", options->refinements,
                   "runs after the first, each refining the building (default 0)")
      ->check(CLI::Range(0, 100));
  verb->add_option("--speed", options->speed_mps, "cruising speed [m/s]")->check(CLI::Range(0.05, 5.0));
  Choices<BuildingKind> kinds;
  for (const BuildingKind kind : kBuildingKinds) kinds.emplace_back(name_of(kind), kind);
  add_choice<std::optional<BuildingKind>>(*verb, "--kind", options->kind, {kinds.begin(), kinds.end()},
                                          "kind of random buildings (default: all in turn)");
  verb->add_option("--noise-scale", options->noise_scale, "factor on the odometry's errors (default 1)")
      ->check(CLI::Range(0.0, 20.0));
  verb->add_flag("--start-anywhere", options->starts_anywhere,
                 "start at a random place, with a random heading, in place of the world's start");
  verb->add_option("--lift", options->lift_m,
                   "kidnap the vehicle once, and put it down so far ahead or back on its path [m]")
      ->check(CLI::Range(0.5, 100.0));
  verb->add_flag("--reverse", options->in_reverse,
                 "drive the routes in the opposite direction, or back into the parking frame");
  verb->add_flag("--outdated-map", options->outdated_map,
                 "in a map of 5 cm cells, made before 5 % of the walls were built and the furniture "
                 "was moved");
  verb->add_flag("--close", options->close,
                 "pairs that are too close for the vehicle, so that it backs up between them");
  name_methods_in_help(*verb);
  const CLI::Option* only = verb->add_option(
      "--only", options->only,
      "run one of the trial's missions, by its name, such as 'seed 5': as it would run among all");
  const CLI::Option* jobs = add_jobs(*verb, options->jobs);
  const CLI::Option* out = verb->add_option(
      "-o,--out", options->out,
      "directory that keeps each mission as it ends; the same command goes on from there, and shares the "
      "missions with others that run it at the same time");
  const CLI::Option* force =
      verb->add_flag("--force", options->force, "replace the missions that --out holds");
  add_parameter_options(*verb, options->parameters, trial_parameters, work, [=] {
    if (options->method.empty()) throw CLI::RequiredError("METHOD");
    refuse_unused_options(*verb, present_method(options->method));
    options->words = words_of(*verb, {seeds, only, jobs, out, force});
    options->process = trial_process_from_environment();
    chosen(*options);
  });
}
