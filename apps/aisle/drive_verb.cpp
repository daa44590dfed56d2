#include <unistd.h>

#include <iostream>
#include <iterator>
#include <memory>

#include "aisle/commands/drive.hpp"
#include "aisle/formats/key_script_text.hpp"
#include "aisle/formats/whole_file.hpp"
#include "option_kinds.hpp"
#include "terminal_operator.hpp"
#include "verb.hpp"

using namespace aisle;

namespace {

enum class Hands { kAsFits, kKeys, kScripted };

/// Keys with their times, from a file or from stdin.
Result<std::unique_ptr<Operator>> timed_keys(const std::string& file, const VehicleDescription& vehicle,
                                             const KeySpeeds& speeds) {
  constexpr std::size_t kBytesMax = 16 << 20;
  Result<std::string> text = std::string();
  if (file.empty()) {
    text = std::string(std::istreambuf_iterator<char>(std::cin), {});
  } else {
    text = read_whole_file(file, kBytesMax);
  }
  if (!text) return text.problems();
  auto keys = parse_key_script(*text, file.empty() ? "stdin" : file);
  if (!keys) return keys.problems();
  return std::unique_ptr<Operator>(
      std::make_unique<KeyScript>(std::move(*keys), speeds, vehicle.is_differential));
}

DriveOptions::KeyOperator key_operator(Hands person, const std::string& file, bool quiet) {
  const bool has_terminal = isatty(STDIN_FILENO) != 0;
  if (person == Hands::kScripted || (person == Hands::kAsFits && file.empty() && !has_terminal)) return {};
  if (!file.empty() || !has_terminal) {
    return [file](const VehicleDescription& vehicle, const KeySpeeds& speeds) {
      return timed_keys(file, vehicle, speeds);
    };
  }
  return [quiet](const VehicleDescription& vehicle,
                 const KeySpeeds& speeds) -> Result<std::unique_ptr<Operator>> {
    const bool shows_status = !quiet && isatty(STDERR_FILENO) != 0;
    return std::unique_ptr<Operator>(
        std::make_unique<TerminalOperator>(speeds, vehicle.is_differential, shows_status));
  };
}

}  // namespace

void add_drive_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand("drive", "drive a simulated vehicle through a world by hand");
  verb->fallthrough();
  auto options = std::make_shared<DriveOptions>();
  auto person = std::make_shared<Hands>(Hands::kAsFits);
  auto keys = std::make_shared<std::string>();
  auto no_pictures = std::make_shared<bool>(false);
  verb->add_option("WORLD", options->world, "world file (YAML), or the name of a shipped one");
  verb->add_option("--vehicle", options->vehicle,
                   "vehicle file (YAML), or the name of a shipped one (default alv)");
  verb->add_option("--scenario", options->scenario,
                   "scenario file (YAML) of what goes wrong, or the name of a shipped one");
  add_seed(*verb, options->seed, "of all noise; the same seed gives the same session (default 1)");
  verb->add_option("--out", options->out, "directory for the session");
  verb->add_flag("--force", options->force, "replace a session that is there already");
  add_choice<Hands>(*verb, "--operator", *person, {{"keys", Hands::kKeys}, {"scripted", Hands::kScripted}},
                    "keys: arrows, q, space in the terminal, or timed keys from stdin; scripted: a person "
                    "follows the world's tour (default: keys in a terminal, else scripted)");
  verb->add_option("--keys", *keys, "file of timed keys to press, such as '0-3 up'; faster than real time");
  verb->add_flag("--no-pictures", *no_pictures, "the cameras see nothing: faster");
  add_parameter_options(*verb, options->parameters, drive_parameters, work, [=, &app, &work] {
    if (options->world.empty()) throw CLI::RequiredError("WORLD");
    options->takes_pictures = !*no_pictures;
    options->keys = key_operator(*person, *keys, app.count("--quiet") > 0);
    work = [options](Console& console) { return run_drive(*options, console); };
  });
}
