#include "settings_check.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

namespace aisle {
namespace {

/// Ports of greater domains overlap with those that Linux gives to programs at random.
constexpr unsigned kDomainMax = 101;

std::optional<in_addr_t> ipv4(const std::string& text) {
  in_addr address{};
  if (inet_pton(AF_INET, text.c_str(), &address) != 1) return std::nullopt;
  return ntohl(address.s_addr);
}

bool is_of_one_machine(in_addr_t address) {
  return address != INADDR_ANY && !IN_MULTICAST(address) && !IN_BADCLASS(address);
}

bool is_loopback(in_addr_t address) {
  return address >> IN_CLASSA_NSHIFT == IN_LOOPBACKNET;
}

bool contains(const std::vector<std::string>& addresses, const std::string& address) {
  return std::find(addresses.begin(), addresses.end(), address) != addresses.end();
}

std::optional<std::string> peer_problem(const std::string& peer, const WireSettings& settings,
                                        const std::vector<std::string>& own) {
  const auto address = ipv4(peer);
  if (!address || !is_of_one_machine(*address))
    return fmt::format("'{}' is not an IPv4 address of a machine, such as 192.168.1.20", peer);
  const auto from = ipv4(settings.interface_address);
  if (from && is_loopback(*from) && !is_loopback(*address) && !contains(own, peer))
    return fmt::format("'{}' is another machine, which the interface {} does not reach", peer,
                       settings.interface_address);
  return std::nullopt;
}

}  // namespace

std::vector<std::string> own_addresses() {
  ifaddrs* list = nullptr;
  if (getifaddrs(&list) != 0) return {};
  const std::unique_ptr<ifaddrs, decltype(&freeifaddrs)> owned(list, freeifaddrs);
  std::vector<std::string> addresses;
  for (const ifaddrs* at = list; at != nullptr; at = at->ifa_next) {
    if (at->ifa_addr == nullptr || at->ifa_addr->sa_family != AF_INET || (at->ifa_flags & IFF_RUNNING) == 0)
      continue;
    std::array<char, INET_ADDRSTRLEN> text{};
    inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in*>(at->ifa_addr)->sin_addr, text.data(),
              text.size());
    addresses.emplace_back(text.data());
  }
  return addresses;
}

Problems check_settings(const WireSettings& settings, const std::vector<std::string>& own) {
  Problems problems;
  if (settings.domain > kDomainMax)
    problems.push_back({{.key = "domain"}, fmt::format("{} is not in 0 to {}", settings.domain, kDomainMax)});
  if (!contains(own, settings.interface_address))
    problems.push_back({{.key = "interface"},
                        fmt::format("'{}' is not an address of this machine, which has {}",
                                    settings.interface_address, fmt::join(own, ", "))});
  for (const std::string& peer : settings.peers)
    if (auto what = peer_problem(peer, settings, own))
      problems.push_back({{.key = "peers"}, *std::move(what)});
  return problems;
}

}  // namespace aisle
