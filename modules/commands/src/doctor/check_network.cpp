#include <fmt/format.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

#include <charconv>
#include <cstdlib>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "aisle/wire/wire.hpp"
#include "machine_check.hpp"

namespace aisle {
namespace {

/// ROS_DOMAIN_ID; 0 if it is not set, nothing if it is no number.
std::optional<unsigned> ros_domain() {
  const char* const set = std::getenv("ROS_DOMAIN_ID");  // NOLINT(concurrency-mt-unsafe): nobody sets it
  if (set == nullptr || *set == '\0') return 0;
  const std::string_view text(set);
  unsigned domain = 0;
  const auto [end, error] = std::from_chars(text.begin(), text.end(), domain);
  if (error != std::errc() || end != text.end()) return std::nullopt;
  return domain;
}

/// The interfaces besides the loopback that are up, have an IPv4 address and take multicast.
std::set<std::string> multicast_interfaces() {
  ifaddrs* listed = nullptr;
  if (getifaddrs(&listed) != 0) return {};
  const std::unique_ptr<ifaddrs, decltype(&freeifaddrs)> all(listed, freeifaddrs);
  constexpr unsigned kUsable = IFF_UP | IFF_MULTICAST;
  std::set<std::string> names;
  for (const ifaddrs* at = listed; at != nullptr; at = at->ifa_next) {
    const bool has_address = at->ifa_addr != nullptr && at->ifa_addr->sa_family == AF_INET;
    if (has_address && (at->ifa_flags & (kUsable | IFF_LOOPBACK)) == kUsable) names.insert(at->ifa_name);
  }
  return names;
}

}  // namespace

MachineCheck check_ros_network() {
  MachineCheck check{.name = "ROS 2 network"};
  const std::optional<unsigned> domain = ros_domain();
  if (!domain) {
    check.state = MachineState::kLimited;
    check.found = "ROS_DOMAIN_ID is no whole number";
    check.advice = "export ROS_DOMAIN_ID=0, or the number that the robot has";
    return check;
  }
  const auto wire = Wire::open({.domain = *domain});
  if (wire) {
    check.found = fmt::format("domain {} can be joined on this machine (127.0.0.1)", *domain);
    return check;
  }
  check.state = MachineState::kLimited;
  check.found = to_string(wire.problems());
  check.advice = "no robot can be connected: end other programs of that domain, or choose another one";
  return check;
}

MachineCheck check_multicast() {
  const std::set<std::string> names = multicast_interfaces();
  if (!names.empty())
    return {.name = "multicast", .found = fmt::format("taken by {}", fmt::join(names, ", "))};
  return {.name = "multicast",
          .state = MachineState::kLimited,
          .found = "taken by no network interface besides the loopback",
          .advice =
              "name a robot on another machine by its address: '--peer', or 'peers' in its connection file"};
}

}  // namespace aisle
