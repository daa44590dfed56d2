#pragma once

#include <functional>
#include <string>

#include "aisle/commands/drive.hpp"
#include "aisle/commands/outcome.hpp"
#include "aisle/live_session/live_options.hpp"

namespace aisle {

/// `aisle live WORLD`: runs a simulated vehicle in real time, or a robot. It is idle until a client of the
/// live server gives it a mission, and runs until it is interrupted.
/// @param announce  called with the server's address once it listens
Result<Outcome> run_live(const LiveOptions& options, Console& console,
                         const std::function<void(const std::string&)>& announce);

/// A verb's work with its own console; `hand` makes the operator that drives through the live page.
using WatchedWork = std::function<Result<Outcome>(Console& console, const DriveOptions::KeyOperator& hand)>;

/// `--live`: does a verb's work while the live server shows it; clients can pause and stop it.
Result<Outcome> run_watched(const LiveListening& listening, const std::string& verb, const WatchedWork& work,
                            Console& console, const std::function<void(const std::string&)>& announce);

}  // namespace aisle
