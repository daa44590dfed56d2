#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/live/service_call.hpp"
#include "session_index.hpp"

namespace aisle {

/// The names of the services that LiveRequestHandler answers.
std::vector<LiveService> handler_services(ServiceMailbox& calls);

/// Folder of the session that `arguments` name; a problem if there is none.
Result<std::filesystem::path> session_named(const std::filesystem::path& sessions,
                                            const nlohmann::json& arguments);

/// Answers, on its own thread, the services that do not concern the mission: sessions, buildings, mazes.
class LiveRequestHandler {
 public:
  struct Folders {
    std::filesystem::path sessions;  ///< empty: none
    std::filesystem::path buildings;
  };

  /// @param calls  must outlive the request handler, which closes it
  LiveRequestHandler(Folders folders, ServiceMailbox& calls);
  ~LiveRequestHandler();
  LiveRequestHandler(const LiveRequestHandler&) = delete;
  LiveRequestHandler& operator=(const LiveRequestHandler&) = delete;

 private:
  Result<nlohmann::ordered_json> answer(const ServiceCall& call);

  Folders folders_;
  SessionIndex index_;
  ServiceMailbox& calls_;
  std::jthread thread_;
};

}  // namespace aisle
