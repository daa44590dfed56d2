#include <memory>

#include "aisle/commands/sessions/session_cut.hpp"
#include "aisle/commands/sessions/session_info.hpp"
#include "aisle/commands/sessions/session_replay.hpp"
#include "live_options.hpp"
#include "verb.hpp"

using namespace aisle;

namespace {

constexpr const char* kSessionMeaning = "a session's directory";
constexpr double kLongest_s = 1e9;

void add_info_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand("info", "tell what a session holds: topics, rates, gaps, size");
  verb->fallthrough();
  auto options = std::make_shared<SessionInfoOptions>();
  verb->add_option("SESSION", options->session, kSessionMeaning)->required();
  verb->callback([options, &work] { work = [options](Console&) { return run_session_info(*options); }; });
}

void add_cut_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand("cut", "make a session of a part of a session");
  verb->fallthrough();
  auto options = std::make_shared<SessionCutOptions>();
  verb->add_option("SESSION", options->session, kSessionMeaning)->required();
  verb->add_option("--from", options->from_s, "seconds after the session's start; default 0")
      ->check(CLI::Range(0.0, kLongest_s));
  verb->add_option("--to", options->to_s, "seconds after the session's start; default: to the end")
      ->check(CLI::Range(0.0, kLongest_s));
  verb->add_option("-o,--out", options->out, "the new session's directory")->required();
  verb->add_flag("--force", options->force, "replace a session that is there already");
  verb->callback([options, &work] {
    work = [options](Console& console) { return run_session_cut(*options, console); };
  });
}

void add_replay_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand(
      "replay", "decide again on what a session recorded; every decision must be the same");
  verb->fallthrough();
  auto options = std::make_shared<SessionReplayOptions>();
  verb->add_option("SESSION", options->session, kSessionMeaning)->required();
  verb->add_option("--navigator", options->navigator, "who decides; default: the one that drove");
  const LiveOption live(*verb);
  verb->callback([options, live, &work] {
    work = live.around(
        [options](Console& console, const auto&) { return run_session_replay(*options, console); });
  });
}

}  // namespace

void add_session_verbs(CLI::App& app, Work& work) {
  add_info_verb(app, work);
  add_cut_verb(app, work);
  add_replay_verb(app, work);
}
