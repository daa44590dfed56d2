#include "live_options.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "version.hpp"

using namespace aisle;

namespace {

constexpr double kRateMax = 1000;

}  // namespace

void add_listening_options(CLI::App& verb, LiveListening& listening) {
  listening.version = release();
  verb.add_option("--port", listening.port, "port of the page (default 8765; 0: any free port)");
  verb.add_option(
      "--listen", listening.address,
      "address to listen on (default 127.0.0.1); one that other machines can reach, such as 0.0.0.0, "
      "needs --token-file");
  verb.add_option("--token-file", listening.token_file,
                  "file with the access token on one line; clients must present it");
  verb.add_option("--allow-origin", listening.origins,
                  "site of another viewer whose pages may connect, such as https://viewer.example (default: "
                  "none); may be given again")
      ->allow_extra_args(false);
  verb.add_option("--cert", listening.tls.certificate,
                  "TLS certificate (PEM) to serve the page over https; needs --key");
  verb.add_option("--key", listening.tls.key, "private key (PEM) of the certificate");
  verb.add_option("--sessions", listening.sessions, "directory of the sessions that the page lists");
  verb.add_option("--buildings", listening.buildings,
                  "directory of the building files that the page lists, and where it saves edited ones");
  verb.add_option("--web", listening.web, "directory of the page's files (default: the page that was built)");
  verb.add_option("--rate", listening.rate,
                  "simulated seconds per second (default 1; 0: as fast as possible)")
      ->check(CLI::Range(0.0, kRateMax));
}

void announce_live(const std::string& url) {
  fmt::print(stderr, "live: {}\n", url);
  std::fflush(stderr);
}

LiveOption::LiveOption(CLI::App& verb)
    : verb_(verb.get_name()),
      is_wanted_(std::make_shared<bool>(false)),
      listening_(std::make_shared<LiveListening>()) {
  verb.add_flag("--live", *is_wanted_,
                "serve a web page on which the mission can be watched, paused and stopped");
  add_listening_options(verb, *listening_);
}

Work LiveOption::around(const WatchedWork& work) const {
  if (!*is_wanted_) return [work](Console& console) { return work(console, {}); };
  return [work, verb = verb_, listening = listening_](Console& console) {
    return run_watched(*listening, verb, work, console, announce_live);
  };
}
