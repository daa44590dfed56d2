#include "completion.hpp"

#include <fmt/format.h>

#include <map>
#include <sstream>
#include <string_view>

#include "aisle/commands/shipped_files.hpp"

namespace {

/// Words that could follow, with their meaning.
using Candidates = std::map<std::string, std::string>;

bool takes_value(const CLI::Option& option) {
  return option.get_items_expected_max() > 0;
}

/// Where a command line has got to.
struct Reached {
  const CLI::App* verb;
  const CLI::Option* value_of = nullptr;  ///< the option whose value comes next; null: none
  std::size_t positionals = 0;            ///< words so far that are none of options or verbs
};

const CLI::App* verb_below(const CLI::App& verb, const std::string& name) {
  for (const CLI::App* below : verb.get_subcommands([](const CLI::App*) { return true; }))
    if (below->get_name() == name) return below;
  return nullptr;
}

const CLI::Option* option_of(const CLI::App* verb, const std::string& name) {
  for (; verb != nullptr; verb = verb->get_parent())
    if (const CLI::Option* option = verb->get_option_no_throw(name)) return option;
  return nullptr;
}

void advance(Reached& reached, const std::string& word) {
  if (word == "=") return;  // bash takes --option=value for three words
  const CLI::Option* const awaited = std::exchange(reached.value_of, nullptr);
  if (word.starts_with("-")) {
    const CLI::Option* const option = option_of(reached.verb, word);
    if (option != nullptr && takes_value(*option)) reached.value_of = option;
  } else if (awaited == nullptr) {
    if (const CLI::App* below = verb_below(*reached.verb, word))
      reached = {below};
    else
      ++reached.positionals;
  }
}

Candidates options_of(const CLI::App* verb) {
  Candidates candidates;
  for (; verb != nullptr; verb = verb->get_parent())
    for (const CLI::Option* option : verb->get_options())
      for (const std::string& name : option->get_lnames())
        candidates.emplace("--" + name, option->get_description());
  return candidates;
}

/// The choices that an option's help shows: m|cm|mm, or {worlds,vehicles,scenarios}.
Candidates choices_of(const CLI::Option& option) {
  std::string shown = option.get_type_name();
  const std::size_t list = shown.find('{');
  if (list != std::string::npos) shown = shown.substr(list + 1, shown.find('}', list) - list - 1);
  const char separator = list != std::string::npos ? ',' : '|';
  Candidates candidates;
  if (shown.find(separator) == std::string::npos) return candidates;
  std::istringstream words(shown);
  for (std::string word; std::getline(words, word, separator);) candidates.emplace(word, "");
  return candidates;
}

/// The names that an option's help speaks of: "name of a shipped world".
Candidates shipped_for(const CLI::Option& option) {
  Candidates candidates;
  for (const std::string kind : {"world", "vehicle", "scenario"}) {
    if (option.get_description().find("shipped " + kind) == std::string::npos) continue;
    for (const aisle::ShippedFile& file : aisle::shipped_files(kind + "s"))
      candidates.emplace(file.name, file.description);
  }
  return candidates;
}

Candidates values_of(const CLI::Option& option) {
  Candidates candidates = choices_of(option);
  candidates.merge(shipped_for(option));
  return candidates;
}

/// The verbs below, and what the positional that comes next may be.
Candidates words_of(const Reached& reached) {
  Candidates candidates;
  for (const CLI::App* below : reached.verb->get_subcommands([](const CLI::App*) { return true; }))
    candidates.emplace(below->get_name(), below->get_description());
  std::size_t index = 0;
  for (const CLI::Option* option : reached.verb->get_options())
    if (option->get_positional() && index++ == reached.positionals) candidates.merge(values_of(*option));
  return candidates;
}

Candidates candidates_after(const Reached& reached, const std::string& typed) {
  if (reached.value_of != nullptr) return values_of(*reached.value_of);
  return typed.starts_with("-") ? options_of(reached.verb) : words_of(reached);
}

}  // namespace

std::string completions(const CLI::App& program, const std::vector<std::string>& words) {
  if (words.empty()) return {};
  Reached reached{&program};
  for (std::size_t i = 0; i + 1 < words.size(); ++i) advance(reached, words[i]);
  const std::string typed = words.back() == "=" ? "" : words.back();
  std::string lines;
  for (const auto& [word, meaning] : candidates_after(reached, typed)) {
    if (!word.starts_with(typed)) continue;
    lines += word;
    if (!meaning.empty()) lines += '\t' + meaning;
    lines += '\n';
  }
  return lines;
}
