#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/core/terminal_text.hpp"
#include "completion.hpp"
#include "examples.hpp"
#include "former_names.hpp"
#include "manual.hpp"
#include "suggestion.hpp"
#include "terminal_progress.hpp"
#include "verb.hpp"
#include "version.hpp"

namespace {

enum ExitCode { kDone = 0, kMissionFailed = 1, kBadInput = 2, kInternalError = 3, kInterrupted = 130 };

/// Images of 300 kB are allocated and freed among small, long-lived objects. On pages of their own they are
/// returned to the system; in the heap each would leave a hole that is too small for the next.
constexpr int kOwnPages_bytes = 128 * 1024;

struct Output {
  bool json = false;
  bool quiet = false;
};

/// Prints to standard output. @return `code`, or kInternalError if not everything could be written
int print(const std::string& text, ExitCode code) {
  const bool is_complete = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (std::fflush(stdout) == 0 && is_complete) return code;
  fmt::print(stderr, "aisle: standard output could not be written\n");
  return kInternalError;
}

int report(const aisle::Outcome& outcome, const Output& output) {
  if (outcome.is_printed_elsewhere) return kDone;
  return print(output.json ? to_json(outcome) + "\n" : aisle::terminal_text(outcome.text),
               outcome.ok ? kDone : kMissionFailed);
}

int refuse(const std::string& verb, const aisle::Problems& problems, const Output& output) {
  fmt::print(stderr, "{}\n", aisle::terminal_text(to_string(problems)));
  if (!output.json) return kBadInput;
  return print(to_json(aisle::Outcome{.verb = verb, .ok = false, .problems = problems}) + "\n", kBadInput);
}

/// The verb as far as it was parsed: "map", "sim log".
std::string verb_of(const CLI::App& app) {
  std::string words;
  for (const CLI::App* at = &app; !at->get_subcommands().empty();) {
    at = at->get_subcommands().front();
    words += (words.empty() ? "" : " ") + at->get_name();
  }
  return words;
}

/// Refuses empty arguments, such as a shell variable that was never set: they must not count as omitted.
void refuse_empty_arguments(const CLI::App& verb) {
  for (const CLI::Option* option : verb.get_options()) {
    for (const std::string& word : option->results()) {
      if (word.empty()) throw CLI::ValidationError(option->get_name(), "must not be empty");
    }
  }
  for (const CLI::App* below : verb.get_subcommands()) refuse_empty_arguments(*below);
}

bool was_given(int argc, char** argv, std::string_view flag) {
  return std::any_of(argv, argv + argc, [&](std::string_view word) { return word == flag; });
}

int refuse_usage(const CLI::App& app, const CLI::ParseError& error, Output output, int argc, char** argv) {
  // The parser stops at the first error, which may come before --json.
  output.json = was_given(argc, argv, "--json");
  const CLI::App* deepest = &app;
  while (!deepest->get_subcommands().empty()) deepest = deepest->get_subcommands().front();
  const std::string verb = verb_of(app);
  const std::string program = verb.empty() ? "aisle" : "aisle " + verb;
  const bool has_verbs_below = !deepest->get_subcommands([](const CLI::App*) { return true; }).empty();
  const std::vector<std::string> unknown = app.remaining(true);
  std::string why = error.what();
  if (has_verbs_below && !unknown.empty()) why = "unknown verb or option '" + unknown.front() + "'";
  const auto word = std::find_if(unknown.begin(), unknown.end(), [&](const std::string& one) {
    return has_verbs_below || one.starts_with("--");
  });
  if (word != unknown.end()) why += suggestion(*deepest, *word);
  return refuse(verb, {{{program}, fmt::format("{} (see {} --help)", why, program)}}, output);
}

int run(const std::string& verb, const Work& work, const Output& output) {
  const aisle::SteadyClock clock;
  TerminalProgress progress(clock, !output.quiet && isatty(STDERR_FILENO) != 0);
  aisle::Console console{progress, [&](const std::string& warning) {
                           progress.clear();
                           if (!output.quiet)
                             fmt::print(stderr, "warning: {}\n", aisle::terminal_text(warning));
                         }};
  catch_interrupts();
  try {
    const aisle::Result<aisle::Outcome> outcome = work(console);
    progress.clear();
    return outcome ? report(*outcome, output) : refuse(verb, outcome.problems(), output);
  } catch (const aisle::Interrupted&) {
    progress.clear();
    fmt::print(stderr, "interrupted\n");
    return kInterrupted;
  }
}

void add_verbs(CLI::App& app, Work& work) {
  add_show_verbs(app, work);
  add_doctor_verb(app, work);
  add_convert_verb(app, work);
  add_map_verb(app, work);
  add_localise_verb(app, work);
  add_merge_verbs(app, work);
  add_compare_verb(app, work);
  add_sim_verb(app, work);
  add_maze_verb(app, work);
  add_session_verbs(app, work);
  add_import_verb(app, work);
  add_detect_verb(app, work);
  add_calibrate_verb(app, work);
  add_drive_verb(app, work);
  add_explore_verb(app, work);
  add_connect_verb(app, work);
  add_guide_verbs(app, work);
  add_fleet_verb(app, work);
  add_learning_verbs(app, work);
  add_live_verb(app, work);
  add_park_verb(app, work);
  add_reproduce_verb(app, work);
  add_trial_verb(app, work);
  add_study_verb(app, work);
  add_examples(app, {"aisle explore small-office --out out/office",
                     "aisle go out/office/building.json \"end 1\" --world small-office", "aisle help map"});
}

/// `aisle manual DIR`, which the build runs: the help as manual pages.
int write_manual(const CLI::App& app, const std::filesystem::path& directory) {
  std::filesystem::create_directories(directory);
  for (const auto& [name, page] : manual_pages(app)) {
    std::ofstream file(directory / name);
    if (file << page << std::flush) continue;
    fmt::print(stderr, "{}: cannot be written\n", (directory / name).string());
    return kInternalError;
  }
  return kDone;
}

int run_program(int argc, char** argv) {
  CLI::App app("a robot vehicle that learns a building and drives there autonomously", "aisle");
  app.set_version_flag("--version", version());
  app.require_subcommand(1);
  Output output;
  app.add_flag("--json", output.json, "print one JSON object instead of text");
  app.add_flag("--quiet", output.quiet, "print neither warnings nor a progress bar");
  Work work;
  add_verbs(app, work);
  app.footer(app.get_footer() +
             "\n\nExit status:\n  0 done; 1 the mission failed; 2 bad usage or bad input; 3 internal error; "
             "130 interrupted");
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  const std::string first = words.empty() ? "" : words.front();
  // What shells and the build ask for is no verb: the words behind `complete` are still being typed.
  if (first == "complete") return print(completions(app, {words.begin() + 1, words.end()}), kDone);
  if (first == "manual" && words.size() == 2) return write_manual(app, words.back());
  if (first == "help") {  // `aisle help map` is `aisle map --help`
    words.erase(words.begin());
    words.emplace_back("--help");
  }
  for (const std::string& warning : use_present_names(app, words)) {
    if (!was_given(argc, argv, "--quiet")) fmt::print(stderr, "warning: {}\n", aisle::terminal_text(warning));
  }
  std::reverse(words.begin(), words.end());  // as the parser takes them
  try {
    app.parse(words);
    refuse_empty_arguments(app);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    return refuse_usage(app, error, output, argc, argv);
  }
  return run(verb_of(app), work, output);
}

}  // namespace

int main(int argc, char** argv) {
  mallopt(M_MMAP_THRESHOLD, kOwnPages_bytes);
  try {
    return run_program(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "aisle: internal error: %s\n", error.what());
  } catch (...) {
    std::fprintf(stderr, "aisle: internal error\n");
  }
  return kInternalError;
}
