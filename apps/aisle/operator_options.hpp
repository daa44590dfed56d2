#pragma once

#include <string>

#include "aisle/commands/drive.hpp"
#include "live_options.hpp"
#include "verb.hpp"

/// Who drives by hand; kAsFits: keys in a terminal or from a file, else scripted.
enum class OperatorKind { kAsFits, kKeys, kScripted, kPage };

struct OperatorOptions {
  OperatorKind kind = OperatorKind::kAsFits;
  std::string keys;  ///< file of timed keys; may be empty
};

/// --operator and --keys.
void add_operator_options(CLI::App& verb, OperatorOptions& options);

/// Refuses --operator page without --live.
void check_page_driver(const OperatorOptions& options, const LiveOption& live);

/// Makes the operator at the keys; null if the driver is scripted or on the page.
aisle::DriveOptions::KeyOperator key_operator(const OperatorOptions& options, bool quiet);
