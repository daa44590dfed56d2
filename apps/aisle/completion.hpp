#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

/// What could stand where a command line ends: the verbs, options, choices and names of shipped files that
/// begin like the last of `words`, one a line, each with a tab and its meaning behind it where it has one.
/// Empty where a file or a value of the user's own belongs.
/// @param words  what is typed behind the program's name; the last one, which may be empty, is being typed
std::string completions(const CLI::App& program, const std::vector<std::string>& words);
