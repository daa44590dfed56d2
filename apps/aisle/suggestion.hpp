#pragma once

#include <CLI/CLI.hpp>
#include <string>

/// "; did you mean --out?": the verb's option or the verb below it that is spelt most like a word that it
/// does not know. Empty if none is near.
std::string suggestion(const CLI::App& verb, const std::string& word);
