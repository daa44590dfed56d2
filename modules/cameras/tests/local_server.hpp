#pragma once
/// The network side of cameras that tests make up, on 127.0.0.1. Everything happens on the test's own thread.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "patience.hpp"

namespace aisle {

class Socket {
 public:
  explicit Socket(int handle) : handle_(handle) {
    if (handle_ < 0) throw std::runtime_error("no socket");
  }
  Socket(Socket&& other) noexcept : handle_(std::exchange(other.handle_, -1)) {}
  Socket& operator=(Socket&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  ~Socket() {
    if (handle_ >= 0) ::close(handle_);
  }

  int handle() const { return handle_; }

  void wait_for_input() const {
    pollfd waiting{handle_, POLLIN, 0};
    if (::poll(&waiting, 1, std::chrono::milliseconds(kPatience).count()) != 1)
      throw std::runtime_error("nobody came");
  }

  /// @return false if the other side is gone
  bool write(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = ::send(handle_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (written <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
  }

  /// The head of the next request; empty if the other side is gone.
  std::string read_request() const {
    std::string request;
    while (!request.ends_with("\r\n\r\n")) {
      wait_for_input();
      char byte = 0;
      if (::recv(handle_, &byte, 1, 0) != 1) return "";
      request += byte;
    }
    return request;
  }

 private:
  int handle_;
};

/// Holds a port, on which it listens or not.
class LocalServer {
 public:
  LocalServer() : holder_(bound(0)), listener_(bound(port())) { listen(); }

  std::uint16_t port() const {
    sockaddr_in address{};
    socklen_t size = sizeof(address);
    ::getsockname(holder_.handle(), reinterpret_cast<sockaddr*>(&address), &size);
    return ntohs(address.sin_port);
  }

  std::string address() const { return "127.0.0.1:" + std::to_string(port()); }

  Socket accept() const {
    listener_.wait_for_input();
    return Socket(::accept(listener_.handle(), nullptr, nullptr));
  }

  /// From now on connections are refused, those that wait too.
  void die() { listener_ = bound(port()); }

  void come_back() { listen(); }

 private:
  void listen() const {
    if (::listen(listener_.handle(), 16) != 0) throw std::runtime_error("the port cannot be listened on");
  }

  static Socket bound(std::uint16_t port) {
    Socket socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    const int yes = 1;
    ::setsockopt(socket.handle(), SOL_SOCKET, SO_REUSEPORT, &yes, sizeof(yes));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (::bind(socket.handle(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0)
      throw std::runtime_error("the port is taken");
    return socket;
  }

  Socket holder_;  ///< never listens: keeps others off the port while the server is dead
  Socket listener_;
};

}  // namespace aisle
