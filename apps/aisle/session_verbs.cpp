#include <memory>

#include "aisle/commands/sessions/session_cut.hpp"
#include "aisle/commands/sessions/session_info.hpp"
#include "aisle/commands/sessions/session_replay.hpp"
#include "examples.hpp"
#include "live_options.hpp"
#include "option_kinds.hpp"
#include "verb.hpp"

using namespace aisle;

namespace {

constexpr const char* kSessionMeaning = "session directory";
constexpr double kLongest_s = 1e9;

void add_info_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand(
      "info", "show what a session, a bag or a laser log contains: topics, rates, gaps, size");
  verb->fallthrough();
  add_examples(*verb, {"aisle info out/run", "aisle info drive.bag"});
  auto options = std::make_shared<SessionInfoOptions>();
  verb->add_option("INPUT", options->input, "session directory, or a recording: ROS bag, laser log")
      ->required();
  verb->callback([options, &work] {
    work = [options](Console& console) { return run_session_info(*options, console); };
  });
}

void add_cut_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand("cut", "cut a part out of a session into a new session");
  verb->fallthrough();
  add_examples(*verb, {"aisle cut out/run --to 60 -o out/first-minute",
                       "aisle cut out/run --from 10 --to 20 --storage mcap -o out/part"});
  auto options = std::make_shared<SessionCutOptions>();
  verb->add_option("SESSION", options->session, kSessionMeaning)->required();
  verb->add_option("--from", options->from_s,
                   "first second of the part, since the session's start (default 0)")
      ->check(CLI::Range(0.0, kLongest_s));
  verb->add_option("--to", options->to_s,
                   "last second of the part, since the session's start (default: the session's end)")
      ->check(CLI::Range(0.0, kLongest_s));
  verb->add_option("-o,--out", options->out, "directory of the new session")->required();
  verb->add_flag("--force", options->force, "overwrite an existing session");
  add_storage(*verb, options->storage);
  verb->callback([options, &work] {
    work = [options](Console& console) { return run_session_cut(*options, console); };
  });
}

void add_replay_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand(
      "replay", "run a navigator on the recorded observations and check that every decision is the same");
  verb->fallthrough();
  add_examples(*verb, {"aisle replay out/run", "aisle replay out/imported --navigator explorer --live"});
  auto options = std::make_shared<SessionReplayOptions>();
  verb->add_option("SESSION", options->session, kSessionMeaning)->required();
  verb->add_option("--navigator", options->navigator, "navigator to run (default: the one that drove)");
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
