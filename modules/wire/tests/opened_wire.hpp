#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "aisle/wire/wire.hpp"
#include "cyclone_peer.hpp"

namespace aisle {

/// On the network of the tests, on this machine alone.
inline std::unique_ptr<Wire> opened_wire() {
  auto wire = Wire::open({.domain = test_domain()});
  if (!wire) throw std::runtime_error(to_string(wire.problems()));
  return std::move(*wire);
}

template <class T>
T opened(Result<T> result) {
  if (!result) throw std::runtime_error(to_string(result.problems()));
  return std::move(*result);
}

inline Wire::Sink into(Inbox& inbox) {
  return [&inbox](std::string_view message) { inbox.put(message); };
}

/// The endpoints on the topics of this test: others may run on the same network.
inline std::vector<WireEndpoint> endpoints_of_test(const Wire& wire) {
  std::vector<WireEndpoint> found;
  for (WireEndpoint& endpoint : wire.endpoints())
    if (endpoint.topic.starts_with(test_topic(""))) found.push_back(std::move(endpoint));
  return found;
}

}  // namespace aisle
