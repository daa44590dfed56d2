#include "command_topic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace aisle {
namespace {

using EndpointKind = WireEndpoint::Kind;

std::set<std::string> types_at(const std::vector<WireEndpoint>& endpoints, const std::string& topic,
                               EndpointKind kind) {
  std::set<std::string> types;
  for (const WireEndpoint& endpoint : endpoints) {
    if (endpoint.topic == topic && endpoint.kind == kind) types.insert(endpoint.type);
  }
  return types;
}

std::string known_types() {
  std::vector<std::string> types;
  types.reserve(kCommandKinds.size());
  for (const CommandKind kind : kCommandKinds) types.push_back(command_type(kind));
  return fmt::format("{}", fmt::join(types, ", "));
}

}  // namespace

Result<CommandKind> kind_read(const std::vector<WireEndpoint>& endpoints, const std::string& topic,
                              CommandKind wanted) {
  const std::set<std::string> types = types_at(endpoints, topic, EndpointKind::kSubscriber);
  const auto problem = [&](std::string what) { return Problem{{topic}, std::move(what)}; };
  if (types.empty()) return problem("nobody reads this topic: is it where the robot takes its commands?");
  if (wanted != CommandKind::kAuto) {
    if (types.count(command_type(wanted)) > 0) return wanted;
    return problem(fmt::format("is read as {}, not as {}, which the connection asks for",
                               fmt::join(types, ", "), command_type(wanted)));
  }
  std::vector<CommandKind> kinds;
  for (const std::string& type : types) {
    if (const auto kind = command_kind(type)) kinds.push_back(*kind);
  }
  if (kinds.empty())
    return problem(fmt::format("is read as {}; aisle sends {}", fmt::join(types, ", "), known_types()));
  if (kinds.size() > 1)
    return problem(
        fmt::format("is read as {}: say which with 'command: {{type: ...}}'", fmt::join(types, " and as ")));
  return kinds.front();
}

std::string command_obstacle(const std::vector<WireEndpoint>& endpoints, const std::string& topic,
                             CommandKind kind) {
  if (!types_at(endpoints, topic, EndpointKind::kPublisher).empty())
    return fmt::format("another program sends commands on {}", topic);
  if (types_at(endpoints, topic, EndpointKind::kSubscriber).count(command_type(kind)) == 0)
    return fmt::format("nobody reads the commands on {}", topic);
  return {};
}

}  // namespace aisle
