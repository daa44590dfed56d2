#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>

/// The program's help as manual pages, file name -> roff: aisle.1, and one for each verb with all verbs below
/// it, such as aisle-sim.1.
std::map<std::string, std::string> manual_pages(const CLI::App& program);
