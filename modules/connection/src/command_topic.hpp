#pragma once

#include <string>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/wire/wire.hpp"
#include "command_messages.hpp"

namespace aisle {

/// What kind of commands a robot reads on a topic.
/// @param wanted  kAuto: the one that it reads
/// @return a problem if nobody reads there, or nothing that aisle sends
Result<CommandKind> kind_read(const std::vector<WireEndpoint>& endpoints, const std::string& topic,
                              CommandKind wanted);

/// Why no commands may be sent to a topic; empty: they may. Somebody else sends there, or nobody reads.
std::string command_obstacle(const std::vector<WireEndpoint>& endpoints, const std::string& topic,
                             CommandKind kind);

}  // namespace aisle
