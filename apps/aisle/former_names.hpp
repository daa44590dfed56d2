#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

/// Gives the options of a command line their present names, where they are called as they were before.
/// @param words  the command line without the program's name
/// @return one warning for each option that was renamed
std::vector<std::string> use_present_names(const CLI::App& app, std::vector<std::string>& words);
