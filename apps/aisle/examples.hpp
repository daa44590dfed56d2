#pragma once

#include <CLI/CLI.hpp>
#include <initializer_list>
#include <string_view>

/// Whole commands at the end of a verb's --help. Verbs below a verb inherit them, so they come after those.
void add_examples(CLI::App& verb, std::initializer_list<std::string_view> commands);
