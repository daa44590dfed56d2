#pragma once

#include <string>

#include "aisle/commands/drive.hpp"
#include "verb.hpp"

/// Who drives by hand.
enum class Hands { kAsFits, kKeys, kScripted };

struct HandOptions {
  Hands person = Hands::kAsFits;
  std::string keys;  ///< file of timed keys; may be empty
};

/// --operator and --keys.
void add_hand_options(CLI::App& verb, HandOptions& options);

/// The person that the options mean; null: a scripted one.
aisle::DriveOptions::KeyOperator key_operator(const HandOptions& options, bool quiet);
