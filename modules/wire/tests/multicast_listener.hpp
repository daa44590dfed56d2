#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <string>
#include <string_view>

#include "waiting.hpp"

namespace aisle {

/// Hears what is announced on the loopback to all participants of a domain.
class MulticastListener {
 public:
  explicit MulticastListener(unsigned domain) {
    address_.sin_family = AF_INET;
    address_.sin_port = htons(static_cast<std::uint16_t>(7400 + 250 * domain));
    address_.sin_addr.s_addr = inet_addr("239.255.0.1");
    const int yes = 1;
    setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    const in_addr loopback{htonl(INADDR_LOOPBACK)};
    const ip_mreq membership{address_.sin_addr, loopback};
    setsockopt(socket_, IPPROTO_IP, IP_ADD_MEMBERSHIP, &membership, sizeof membership);
    setsockopt(socket_, IPPROTO_IP, IP_MULTICAST_IF, &loopback, sizeof loopback);
    is_bound_ = bind(socket_, address(), sizeof address_) == 0;
  }
  MulticastListener(const MulticastListener&) = delete;
  MulticastListener& operator=(const MulticastListener&) = delete;
  ~MulticastListener() { close(socket_); }

  /// Whether this machine has multicast at all.
  bool hears_itself() const {
    constexpr std::string_view kWord = "echo";
    if (!is_bound_ || sendto(socket_, kWord.data(), kWord.size(), 0, address(), sizeof address_) < 0)
      return false;
    for (int tries = 0; tries < 100; ++tries) {
      if (heard() == kWord) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

  /// The next datagram; empty: none has come.
  std::string heard() const {
    std::array<char, 2048> bytes{};
    const ssize_t size = recv(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT);
    return {bytes.data(), size > 0 ? static_cast<std::size_t>(size) : 0};
  }

 private:
  const sockaddr* address() const { return reinterpret_cast<const sockaddr*>(&address_); }

  int socket_ = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in address_{};
  bool is_bound_ = false;
};

}  // namespace aisle
