#include "former_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

namespace {

struct FormerName {
  std::string_view verb;  ///< verbs below it are meant, too
  std::string_view former, present;
};

/// The list for users is in docs/reference/command-line.md.
constexpr FormerName kFormerNames[] = {
    {"calibrate camera", "--name", "--camera"},
    {"calibrate floor", "--camera", "--calibration"},
    {"calibrate laser", "--camera", "--calibration"},
    {"connect init", "--size", "--footprint"},
    {"connect init", "--speed", "--speed-max"},
    {"convert", "--from", "--plan-format"},
    {"convert", "--size", "--corridor-length"},
    {"detect", "--camera", "--calibration"},
    {"detect", "--overlay", "--out"},
    {"drive", "--no-pictures", "--no-images"},
    {"drive", "--scenario", "--faults"},
    {"import", "--rate", "--image-rate"},
    {"maze explore", "--speed", "--move-rate"},
    {"sim render", "--at", "--pose"},
    {"sim render", "--output", "--out"},
};

/// The verb that a command line names: "drive", "sim render".
std::string named_verb(const CLI::App& app, const std::vector<std::string>& words) {
  std::string verb;
  const CLI::App* at = &app;
  for (const std::string& word : words) {
    if (word.starts_with('-')) continue;
    const auto below = at->get_subcommands([&](const CLI::App* one) { return one->get_name() == word; });
    if (below.empty()) break;
    at = below.front();
    verb += (verb.empty() ? "" : " ") + word;
  }
  return verb;
}

/// The present name of an option; nullopt: it has no other.
std::optional<std::string_view> present_name(const std::string& verb, std::string_view name) {
  for (const FormerName& one : kFormerNames) {
    const bool is_of_verb = verb == one.verb || verb.starts_with(std::string(one.verb) + ' ');
    if (is_of_verb && one.former == name) return one.present;
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::string> use_present_names(const CLI::App& app, std::vector<std::string>& words) {
  const std::string verb = named_verb(app, words);
  std::vector<std::string> warnings;
  for (std::string& word : words) {
    if (word == "--") break;  // what follows is no option
    const std::string former = word.substr(0, word.find('='));
    const auto present = present_name(verb, former);
    if (!present) continue;
    word.replace(0, former.size(), *present);
    warnings.push_back(fmt::format("{} of aisle {} is now {}", former, verb, *present));
  }
  return warnings;
}
