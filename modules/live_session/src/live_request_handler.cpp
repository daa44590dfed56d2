#include "live_request_handler.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include "aisle/commands/sessions/session_info.hpp"
#include "live_arguments.hpp"
#include "live_maze.hpp"

namespace aisle {
namespace fs = std::filesystem;

namespace {

using OrderedJson = nlohmann::ordered_json;

/// The entries of a folder, by name.
std::vector<fs::path> sorted_entries(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
    entries.push_back(at->path());
  std::sort(entries.begin(), entries.end());
  return entries;
}

OrderedJson building_list(const fs::path& folder) {
  OrderedJson rows = OrderedJson::array();
  for (const fs::path& file : sorted_entries(folder)) {
    std::error_code error;
    const auto bytes = fs::file_size(file, error);
    if (!error && file.extension() == ".json")
      rows.push_back({{"name", file.stem().string()}, {"bytes", bytes}});
  }
  return {{"buildings", std::move(rows)}};
}

Result<OrderedJson> session_figures(const fs::path& sessions, const nlohmann::json& arguments) {
  const auto session = session_named(sessions, arguments);
  if (!session) return session.problems();
  SilentProgress silent;
  Console console{silent, [](const std::string&) {}};
  auto info = run_session_info({*session}, console);
  if (!info) return info.problems();
  return std::move(info->figures);
}

}  // namespace

std::vector<LiveService> handler_services(ServiceMailbox& calls) {
  std::vector<LiveService> services;
  for (const char* name : {"maze/run", "sessions/list", "sessions/info", "buildings/list"})
    services.push_back({name, false, &calls});
  return services;
}

Result<fs::path> session_named(const fs::path& sessions, const nlohmann::json& arguments) {
  LiveArguments read(arguments);
  const std::string name = read.needed_name("session");
  if (Problems problems = read.problems(); !problems.empty()) return problems;
  fs::path session = sessions / name;
  std::error_code error;
  if (sessions.empty() || !fs::exists(session / "metadata.yaml", error))
    return Problem{{"", 0, "session"}, fmt::format("there is no '{}'", name)};
  return session;
}

LiveRequestHandler::LiveRequestHandler(Folders folders, ServiceMailbox& calls)
    : folders_(std::move(folders)),
      index_(folders_.sessions),
      calls_(calls),
      thread_([this](const std::stop_token& stop) {
        while (!stop.stop_requested()) {
          const auto call = calls_.wait(std::chrono::seconds(1));
          if (!call) continue;
          const auto json = answer(*call);
          json ? call->answer(*json) : call->refuse(to_string(json.problems()));
        }
      }) {}

LiveRequestHandler::~LiveRequestHandler() {
  thread_.request_stop();
  calls_.close();
}

Result<OrderedJson> LiveRequestHandler::answer(const ServiceCall& call) {
  const std::string& service = call.service();
  if (service == "maze/run") return maze_steps(call.arguments());
  if (service == "sessions/list") return OrderedJson{{"sessions", index_.rows()}};
  if (service == "sessions/info") return session_figures(folders_.sessions, call.arguments());
  return building_list(folders_.buildings);
}

}  // namespace aisle
