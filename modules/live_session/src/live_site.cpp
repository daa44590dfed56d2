#include "live_site.hpp"

#include <cctype>
#include <utility>
#include <vector>

#include "aisle/commands/shipped_files.hpp"
#include "aisle/formats/whole_file.hpp"
#include "live_control.hpp"

namespace aisle {
namespace {

Result<std::string> token_in(const std::filesystem::path& file) {
  constexpr std::size_t kTokenFileMax = 4096;
  auto text = read_whole_file(file, kTokenFileMax);
  if (!text) return text.problems();
  while (!text->empty() && std::isspace(static_cast<unsigned char>(text->back())) != 0) text->pop_back();
  if (text->empty()) return Problem{{file.string()}, "is empty: it must contain the token on one line"};
  return text;
}

Result<LiveServerOptions> server_options(const LiveListening& listening) {
  LiveServerOptions options{.address = listening.address,
                            .port = listening.port,
                            .token = {},
                            .origins = listening.origins,
                            .tls = listening.tls,
                            .version = listening.version,
                            .folders = {.web = listening.web.empty() ? shipped_page() : listening.web,
                                        .sessions = listening.sessions,
                                        .buildings = listening.buildings}};
  if (listening.token_file.empty()) return options;
  auto token = token_in(listening.token_file);
  if (!token) return token.problems();
  options.token = std::move(*token);
  return options;
}

std::vector<LiveService> all_services(ServiceMailbox& mission_calls, ServiceMailbox& questions) {
  std::vector<LiveService> services = control_services(mission_calls);
  for (const char* name : {"mission/start", "mission/go", "replay/start", "replay/play", "replay/pause",
                           "replay/seek", "replay/rate", "replay/stop", "sessions/rename", "sessions/delete"})
    services.push_back({name, true, &mission_calls});
  const std::vector<LiveService> others = handler_services(questions);
  services.insert(services.end(), others.begin(), others.end());
  return services;
}

}  // namespace

Result<std::unique_ptr<LiveSite>> LiveSite::open(const LiveListening& listening, const Console& console,
                                                 const std::function<void(const std::string&)>& announce) {
  auto options = server_options(listening);
  if (!options) return options.problems();
  std::unique_ptr<LiveSite> site(new LiveSite);
  auto server = LiveServer::open(std::move(*options), all_services(site->mission_calls_, site->questions_));
  if (!server) return server.problems();
  site->server_ = std::move(*server);
  site->handler_ = std::make_unique<LiveRequestHandler>(
      LiveRequestHandler::Folders{.sessions = listening.sessions, .buildings = listening.buildings},
      site->questions_);
  if (site->server_->can_be_overheard())
    console.warn(
        "without --cert and --key the connection is not encrypted: others can read everything, the token "
        "too");
  announce(site->server_->url());
  return site;
}

}  // namespace aisle
