#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "aisle/commands/outcome.hpp"

/// The work that the command line asks for; each verb's parser sets it.
using Work = std::function<aisle::Result<aisle::Outcome>(aisle::Console&)>;

void add_map_verb(CLI::App& app, Work& work);
