#include "examples.hpp"

#include <fmt/format.h>

void add_examples(CLI::App& verb, std::initializer_list<std::string_view> commands) {
  verb.footer(fmt::format("Examples:\n  {}", fmt::join(commands, "\n  ")));
}
