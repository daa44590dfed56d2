#pragma once

#include <string>

#include "aisle/commands/drive.hpp"
#include "live_options.hpp"
#include "verb.hpp"

/// Who drives by hand.
enum class Hands { kAsFits, kKeys, kScripted, kPage };

struct HandOptions {
  Hands person = Hands::kAsFits;
  std::string keys;  ///< file of timed keys; may be empty
};

/// --operator and --keys.
void add_hand_options(CLI::App& verb, HandOptions& options);

/// Who drives from the page needs one: --live.
void check_page_driver(const HandOptions& options, const LiveOption& live);

/// The person that the options mean; null: a scripted one, or one at the page.
aisle::DriveOptions::KeyOperator key_operator(const HandOptions& options, bool quiet);
