#pragma once

#include <atomic>
#include <cstddef>

#include "aisle/live/driver_lease.hpp"
#include "authenticator.hpp"
#include "http_request_handler.hpp"
#include "hub.hpp"

namespace aisle {

/// What all connections share; used by the server's thread alone, but for the counts.
struct ServerContext {
  Hub& hub;
  Authenticator authenticator;
  HttpRequestHandler desk;
  ClientId last_client = 0;
  std::atomic<std::size_t> connections = 0;
  std::atomic<std::size_t> clients = 0;
};

/// Counts a thing as long as it lives.
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
