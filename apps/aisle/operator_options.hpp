#pragma once

#include <string>

#include "aisle/commands/drive.hpp"
#include "live_options.hpp"
#include "verb.hpp"

/// Who drives by hand; kAsFits: keys in a terminal or from a file, else scripted. A robot may also be driven
/// by its joystick, or by another program while aisle only listens.
enum class OperatorKind { kAsFits, kKeys, kScripted, kPage, kJoystick, kOther };

struct OperatorOptions {
  OperatorKind kind = OperatorKind::kAsFits;
  std::string keys;  ///< file of timed keys; may be empty
};

/// --operator and --keys.
void add_operator_options(CLI::App& verb, OperatorOptions& options);

/// Refuses who cannot drive this vehicle: the page without --live, a scripted person a robot, a joystick a
/// simulated one. Tells the drive of a joystick and of another program.
void check_driver(const OperatorOptions& options, const LiveOption& live, aisle::DriveOptions& drive);

/// Makes the operator at the keys; null if the driver is scripted or on the page. Who is driven otherwise may
/// be marked and ended by keys.
aisle::DriveOptions::KeyOperator key_operator(const OperatorOptions& options, bool quiet);
