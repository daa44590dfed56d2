#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <charconv>
#include <chrono>
#include <csignal>
#include <iostream>
#include <memory>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include "aisle/commands/mazes/maze_explore.hpp"
#include "aisle/commands/mazes/maze_generate.hpp"
#include "aisle/commands/mazes/maze_mms.hpp"
#include "aisle/commands/mazes/maze_table.hpp"
#include "examples.hpp"
#include "option_kinds.hpp"
#include "verb.hpp"

using namespace aisle;

namespace {

template <class All>
auto named(const All& values) {
  std::vector<std::pair<std::string, std::decay_t<decltype(values[0])>>> choices;
  for (const auto value : values) choices.emplace_back(name_of(value), value);
  return choices;
}

void add_rules(CLI::App& verb, GridRuleSet& rules, const std::string& shipped = "published") {
  add_choice(verb, "--rules", rules, named(kGridRuleSets),
             "rule set, see docs/explanation/mazes.md (default " + shipped + ")");
}

Cell parse_cell(const std::string& text) {
  Cell cell;
  const char* const end = text.data() + text.size();
  const auto x = std::from_chars(text.data(), end, cell.x);
  if (x.ec == std::errc() && x.ptr != end && *x.ptr == ',') {
    const auto y = std::from_chars(x.ptr + 1, end, cell.y);
    if (y.ec == std::errc() && y.ptr == end) return cell;
  }
  throw CLI::ValidationError("--start", fmt::format("'{}' is not a cell x,y", text));
}

/// A terminal at stdout that shows frames at this rate.
Terminal watching_terminal(double frames_per_s) {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0)
    throw CLI::ValidationError("--watch", "stdout is not a terminal");
  auto is_first = std::make_shared<bool>(true);
  return {size.ws_col, size.ws_row, [frames_per_s, is_first](const std::string& frame) {
            fmt::print("{}{}", *is_first ? "\033[2J" : "", frame);
            std::fflush(stdout);
            *is_first = false;
            std::this_thread::sleep_for(std::chrono::duration<double>(1 / frames_per_s));
          }};
}

void add_table(CLI::App& maze, Work& work) {
  CLI::App* verb = maze.add_subcommand("table", "print all rules of the transducer");
  verb->fallthrough();
  add_examples(*verb, {"aisle maze table", "aisle maze table --rules homing --format dot"});
  auto options = std::make_shared<MazeTableOptions>();
  add_rules(*verb, options->rules);
  add_choice<MazeTableFormat>(
      *verb, "--format", options->format,
      {{"text", MazeTableFormat::kText},
       {"json", MazeTableFormat::kJson},
       {"dot", MazeTableFormat::kDot},
       {"svg", MazeTableFormat::kSvg}},
      "output format; dot: state diagram; svg: drawings of the input symbols (default text)");
  verb->callback(
      [=, &work] { work = [options](Console& console) { return run_maze_table(*options, console); }; });
}

void add_explore(CLI::App& maze, Work& work) {
  CLI::App* verb =
      maze.add_subcommand("explore", "explore every reachable cell of each maze and return to the start");
  verb->fallthrough();
  add_examples(*verb, {"aisle maze explore maze.txt --compare",
                       "aisle maze explore maze.txt --rules homing --svg run.svg --gif run.gif"});
  auto options = std::make_shared<MazeExploreOptions>();
  verb->add_option("FILE", options->files, "maze files: text, mms num, binary .maz, PBM; plain or gzip");
  add_rules(*verb, options->rules);
  verb->add_option_function<std::string>(
      "--start", [options](const std::string& text) { options->start = parse_cell(text); },
      "start cell x,y, counted from the bottom left (default: from the file, else 0,0)");
  verb->add_flag("--compare", options->compare,
                 "compare the moves of all rule sets, of nearest frontier, and of the lower bound");
  auto watch = std::make_shared<bool>(false);
  verb->add_flag("--watch", *watch, "show the run in the terminal: state, stack and fired rule");
  auto frames_per_s = std::make_shared<double>(20);
  verb->add_option("--move-rate", *frames_per_s, "moves per second with --watch (default 20)")
      ->check(CLI::Range(0.1, 1e4));
  verb->add_option("--svg", options->svg, "file for a picture of the run and the learned map");
  verb->add_option("--gif", options->gif, "file for the same as an animation");
  verb->add_flag("--force", options->force, "overwrite existing images");
  verb->callback([=, &work] {
    if (options->files.empty()) throw CLI::RequiredError("FILE");
    if (*watch) options->watch = watching_terminal(*frames_per_s);
    work = [options](Console& console) { return run_maze_explore(*options, console); };
  });
}

void add_generate(CLI::App& maze, Work& work) {
  CLI::App* verb = maze.add_subcommand("generate", "generate a random maze");
  verb->fallthrough();
  add_examples(*verb, {"aisle maze generate --seed 7",
                       "aisle maze generate --kind braided --width 24 --height 12 --out maze.txt"});
  auto options = std::make_shared<MazeGenerateOptions>();
  add_choice(*verb, "--kind", options->recipe.kind, named(kMazeKinds), "kind of maze (default perfect)");
  verb->add_option("--width", options->recipe.width, "width in cells (default 16)");
  verb->add_option("--height", options->recipe.height, "height in cells (default 16)");
  verb->add_option("--loops", options->recipe.loop_share,
                   "share of dead ends that are opened in a braided maze (default 0.5)");
  verb->add_option("--seed", options->seed, "random seed; the same seed gives the same maze (default 1)");
  verb->add_option("-o,--out", options->out, "output file for the maze (default: stdout)");
  verb->add_flag("--force", options->force, "overwrite an existing file");
  verb->callback(
      [=, &work] { work = [options](Console& console) { return run_maze_generate(*options, console); }; });
}

/// stdout belongs to the simulator: figures go there with --json only. Ctrl-C ends the program at once, even
/// while it waits for a reply.
void add_mms(CLI::App& maze, Work& work) {
  CLI::App* verb = maze.add_subcommand("mms", "control a mouse of the mms simulator over stdin and stdout");
  verb->fallthrough();
  add_examples(*verb, {"aisle maze mms", "aisle maze mms --rules roaming"});
  auto options = std::make_shared<MazeMmsOptions>();
  options->replies = &std::cin;
  options->commands = &std::cout;
  add_rules(*verb, options->rules, "homing");
  verb->callback([=, &work] {
    work = [options](Console& console) {
      std::signal(SIGINT, SIG_DFL);
      std::signal(SIGPIPE, SIG_IGN);
      return run_maze_mms(*options, console);
    };
  });
}

}  // namespace

void add_maze_verb(CLI::App& app, Work& work) {
  CLI::App* maze = app.add_subcommand("maze", "explore mazes with a pushdown transducer");
  maze->require_subcommand(1);
  maze->fallthrough();
  add_table(*maze, work);
  add_explore(*maze, work);
  add_generate(*maze, work);
  add_mms(*maze, work);
  add_examples(*maze, {"aisle maze generate --out maze.txt", "aisle maze explore maze.txt --svg run.svg"});
}
