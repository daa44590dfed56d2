#include "operator_options.hpp"

#include <unistd.h>

#include <iostream>
#include <iterator>
#include <memory>

#include "aisle/formats/key_script_text.hpp"
#include "aisle/formats/whole_file.hpp"
#include "option_kinds.hpp"
#include "terminal_operator.hpp"

using namespace aisle;

namespace {

/// Timed keys from a file, or from stdin if no file is named.
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

}  // namespace

void add_operator_options(CLI::App& verb, OperatorOptions& options) {
  add_choice<OperatorKind>(
      verb, "--operator", options.kind,
      {{"keys", OperatorKind::kKeys},
       {"scripted", OperatorKind::kScripted},
       {"page", OperatorKind::kPage},
       {"joystick", OperatorKind::kJoystick},
       {"other", OperatorKind::kOther}},
      "who drives. keys: arrow keys, q and space in the terminal, or timed keys from stdin; scripted: "
      "a scripted person follows the world's tour; page: a person on the page of --live; with --connect also "
      "joystick: the robot's joystick, and other: another program, while aisle sends nothing "
      "(default: keys in a terminal, else scripted)");
  verb.add_option("--keys", options.keys,
                  "file of timed key presses, such as '0-3 up'; runs faster than real time");
}

void check_driver(const OperatorOptions& options, const LiveOption& live, DriveOptions& drive) {
  const auto refuse = [](const char* what) { throw CLI::ValidationError("--operator", what); };
  const bool is_robot = !drive.connection.empty();
  if (options.kind == OperatorKind::kPage && !live.is_wanted()) refuse("page needs --live");
  drive.by_joystick = options.kind == OperatorKind::kJoystick;
  drive.only_listens = options.kind == OperatorKind::kOther;
  if (!is_robot && (drive.by_joystick || drive.only_listens)) refuse("joystick and other need --connect");
  const bool has_keys = !options.keys.empty() || isatty(STDIN_FILENO) != 0;
  if (is_robot &&
      (options.kind == OperatorKind::kScripted || (options.kind == OperatorKind::kAsFits && !has_keys)))
    refuse("a scripted person cannot drive a robot: keys, joystick, page or other");
}

DriveOptions::KeyOperator key_operator(const OperatorOptions& options, bool quiet) {
  const auto& [kind, file] = options;
  const bool has_terminal = isatty(STDIN_FILENO) != 0;
  const bool needs_keys = kind == OperatorKind::kKeys;
  if (kind == OperatorKind::kScripted || kind == OperatorKind::kPage ||
      (!needs_keys && file.empty() && !has_terminal))
    return {};
  if (!file.empty() || !has_terminal) {
    return [file = options.keys](const VehicleDescription& vehicle, const KeySpeeds& speeds) {
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
