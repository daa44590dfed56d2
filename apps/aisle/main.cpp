#include <fmt/format.h>
#include <unistd.h>

#include <exception>

#include "terminal_progress.hpp"
#include "verb.hpp"

namespace {

enum ExitCode { kDone = 0, kMissionFailed = 1, kBadInput = 2, kInternalError = 3, kInterrupted = 130 };

struct Output {
  bool json = false;
  bool quiet = false;
};

int print(const aisle::Outcome& outcome, const Output& output) {
  if (output.json) {
    fmt::print("{}\n", to_json(outcome));
  } else {
    fmt::print("{}", outcome.text);
  }
  return outcome.ok ? kDone : kMissionFailed;
}

int refuse(const std::string& verb, const aisle::Problems& problems, const Output& output) {
  fmt::print(stderr, "{}\n", to_string(problems));
  if (output.json) {
    aisle::Outcome outcome{.verb = verb, .ok = false};
    fmt::print("{}\n", to_json(outcome));
  }
  return kBadInput;
}

int run(const std::string& verb, const Work& work, const Output& output) {
  const aisle::SteadyClock clock;
  TerminalProgress progress(clock, !output.quiet && isatty(STDERR_FILENO) != 0);
  aisle::Console console{progress, [&](const std::string& warning) {
                           progress.clear();
                           if (!output.quiet) fmt::print(stderr, "warning: {}\n", warning);
                         }};
  catch_interrupts();
  try {
    const aisle::Result<aisle::Outcome> outcome = work(console);
    progress.clear();
    return outcome ? print(*outcome, output) : refuse(verb, outcome.problems(), output);
  } catch (const aisle::Interrupted&) {
    progress.clear();
    fmt::print(stderr, "interrupted; nothing was written\n");
    return kInterrupted;
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("aisle: learns the inside of a building and drives there by itself", "aisle");
  app.set_version_flag("--version", AISLE_VERSION);
  app.require_subcommand(1);
  Output output;
  app.add_flag("--json", output.json, "print one JSON object instead of text");
  app.add_flag("--quiet", output.quiet, "no warnings and no progress bar");
  Work work;
  add_map_verb(app, work);
  add_sim_verb(app, work);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kBadInput;
  }
  try {
    return run(app.get_subcommands().front()->get_name(), work, output);
  } catch (const std::exception& error) {
    fmt::print(stderr, "aisle: internal error: {}\n", error.what());
    return kInternalError;
  }
}
