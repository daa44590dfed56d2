#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "aisle/commands/outcome.hpp"
#include "aisle/core/result.hpp"
#include "aisle/live/live_server.hpp"
#include "aisle/live/service_call.hpp"
#include "aisle/live_session/live_options.hpp"
#include "live_request_handler.hpp"

namespace aisle {

/// The live server, the mailbox of the mission's calls, and the request handler for all others.
class LiveSite {
 public:
  /// @param console   warned if the connection can be overheard
  /// @param announce  called with the server's address once it listens
  static Result<std::unique_ptr<LiveSite>> open(const LiveListening& listening, const Console& console,
                                                const std::function<void(const std::string&)>& announce);

  LiveServer& server() { return *server_; }
  /// Calls of control_services(), and of the services that start missions and control replays.
  ServiceMailbox& mission_calls() { return mission_calls_; }

 private:
  LiveSite() = default;

  ServiceMailbox mission_calls_;
  ServiceMailbox questions_;
  std::unique_ptr<LiveServer> server_;
  std::unique_ptr<LiveRequestHandler> handler_;
};

}  // namespace aisle
