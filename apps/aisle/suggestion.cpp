#include "suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "aisle/core/edit_distance.hpp"

namespace {

std::vector<std::string> words_of(const CLI::App& verb) {
  std::vector<std::string> words;
  for (const CLI::App* below : verb.get_subcommands([](const CLI::App*) { return true; }))
    words.push_back(below->get_name());
  for (const CLI::App* app = &verb; app != nullptr; app = app->get_parent()) {
    for (const CLI::Option* option : app->get_options()) {
      for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
    }
  }
  return words;
}

}  // namespace

std::string suggestion(const CLI::App& verb, const std::string& word) {
  const std::vector<std::string> words = words_of(verb);
  const auto distance = [&](const std::string& known) { return aisle::edit_distance(known, word); };
  const auto nearest = std::min_element(
      words.begin(), words.end(), [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  if (nearest == words.end() || distance(*nearest) > std::max<std::size_t>(1, word.size() / 3)) return {};
  return fmt::format("; did you mean {}?", *nearest);
}
