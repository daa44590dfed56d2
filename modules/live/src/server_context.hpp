#pragma once

#include <atomic>
#include <cstddef>

#include "aisle/live/driver_lease.hpp"
#include "authenticator.hpp"
#include "http_request_handler.hpp"
#include "hub.hpp"

namespace aisle {

/// Shared by all connections. Only the counts may be used outside the server's thread.
struct ServerContext {
  Hub& hub;
  Authenticator authenticator;
  HttpRequestHandler request_handler;
  ClientId last_client = 0;
  std::atomic<std::size_t> connections = 0;
  std::atomic<std::size_t> clients = 0;
};

/// Counts an object while it lives.
class Counted {
 public:
  explicit Counted(std::atomic<std::size_t>& count) : count_(&count) { ++*count_; }
  Counted(Counted&& other) noexcept : count_(std::exchange(other.count_, nullptr)) {}
  ~Counted() {
    if (count_ != nullptr) --*count_;
  }
  Counted& operator=(Counted&&) = delete;

 private:
  std::atomic<std::size_t>* count_;
};

}  // namespace aisle
