#include "aisle/commands/mazes/maze_explore.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "aisle/core/process_usage.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/exploration/exploration_run.hpp"
#include "aisle/exploration/walk_bound.hpp"
#include "aisle/formats/mazes/maze_file.hpp"
#include "aisle/formats/whole_file.hpp"
#include "aisle/report/maze_picture.hpp"
#include "aisle/report/maze_screen.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

struct Maze {
  std::string file;
  GridWorld world;
};

/// Shows which of several mazes is being explored; for a single one, its own progress.
class MazeProgress final : public Progress {
 public:
  MazeProgress(Progress& outer, std::size_t mazes) : outer_(outer), mazes_(mazes) {}

  void next() { outer_.report("mazes", ++begun_, mazes_); }
  void report(std::string_view task, std::size_t done, std::size_t total) override {
    if (mazes_ == 1) {
      outer_.report(task, done, total);
    } else {
      outer_.report("mazes", begun_, mazes_);
    }
  }

 private:
  Progress& outer_;
  std::size_t mazes_;
  std::size_t begun_ = 0;
};

/// 1 for a world with a single cell, where there is nothing to walk.
double ratio(std::size_t moves, std::size_t bound) {
  return bound == 0 ? 1 : static_cast<double>(moves) / static_cast<double>(bound);
}

Json run_figures(const ExplorationFigures& figures) {
  return {{"reachable", figures.reachable},
          {"visited", figures.visited},
          {"coverage", rounded(figures.coverage(), 6)},
          {"moves", figures.moves},
          {"moves_over_lower_bound", rounded(ratio(figures.moves, figures.tree_moves()), 6)},
          {"max_edge_uses", figures.max_edge_uses},
          {"max_stack", figures.max_stack},
          {"halted", figures.halted},
          {"ended_at_start", figures.ended_at_start},
          {"stack_empty", figures.stack_empty},
          {"map_equals_truth", figures.map_equals_truth}};
}

/// Totals: sums; for maxima the maximum, for ratios the ratio of the sums, for flags the number that are set.
class Totals {
 public:
  void add(const ExplorationFigures& figures) {
    ++mazes_;
    complete_ += figures.complete();
    sum_.reachable += figures.reachable;
    sum_.visited += figures.visited;
    sum_.moves += figures.moves;
    tree_moves_ += figures.tree_moves();
    sum_.max_edge_uses = std::max(sum_.max_edge_uses, figures.max_edge_uses);
    sum_.max_stack = std::max(sum_.max_stack, figures.max_stack);
    halted_ += figures.halted;
    ended_at_start_ += figures.ended_at_start;
    stack_empty_ += figures.stack_empty;
    map_equals_truth_ += figures.map_equals_truth;
  }

  bool all_complete() const { return complete_ == mazes_; }

  Json json() const {
    Json total = {{"mazes", mazes_}, {"complete", complete_}};
    total.update(run_figures(sum_));
    total["moves_over_lower_bound"] = rounded(ratio(sum_.moves, tree_moves_), 6);
    total["halted"] = halted_;
    total["ended_at_start"] = ended_at_start_;
    total["stack_empty"] = stack_empty_;
    total["map_equals_truth"] = map_equals_truth_;
    return total;
  }

 private:
  ExplorationFigures sum_;
  std::size_t mazes_ = 0, complete_ = 0, tree_moves_ = 0;
  std::size_t halted_ = 0, ended_at_start_ = 0, stack_empty_ = 0, map_equals_truth_ = 0;
};

/// Moves of every rule set, of the baseline, and the lower bound.
Json compare(const Maze& maze, Progress& progress) {
  Json moves = Json::object();
  for (const GridRuleSet set : kGridRuleSets) {
    moves[std::string(name_of(set))] =
        explore(maze.world, maze.world.start, grid_rules(set), progress).figures.moves;
  }
  moves["nearest_frontier"] = explore_nearest_first(maze.world, maze.world.start, progress).figures.moves;
  moves["lower_bound"] = walk_lower_bound(maze.world, maze.world.start);
  if (const auto shortest = shortest_walk(maze.world, maze.world.start)) moves["optimum"] = *shortest;
  return moves;
}

void add_moves(Json& total, const Json& moves) {
  for (const auto& [name, count] : moves.items()) {
    if (name != "optimum") total[name] = total.value(name, std::size_t{0}) + count.get<std::size_t>();
  }
}

std::string comparison_text(const Json& moves) {
  std::string text =
      "moves by rule set                      against published   nearest frontier   lower bound\n";
  const auto against = [&](const Json& count, const char* other) {
    return ratio(count.get<std::size_t>(), moves[other].get<std::size_t>());
  };
  for (const auto& [name, count] : moves.items()) {
    text += fmt::format("  {:<24} {:>12} {:>16.4f} {:>18.4f} {:>13.4f}\n", name, count.get<std::size_t>(),
                        against(count, "published"), against(count, "nearest_frontier"),
                        against(count, "lower_bound"));
  }
  return text;
}

std::string row_text(const std::string& name, const Json& figures, const char* verdict) {
  return fmt::format("{:<44} {:>9} {:>9} {:>10} {:>8.4f} {:>5} {:>6}  {}\n", name,
                     figures["reachable"].get<std::size_t>(), figures["visited"].get<std::size_t>(),
                     figures["moves"].get<std::size_t>(), figures["moves_over_lower_bound"].get<double>(),
                     figures["max_edge_uses"].get<std::size_t>(), figures["max_stack"].get<std::size_t>(),
                     verdict);
}

std::string exploration_text(const Json& figures) {
  const auto is_complete = [](const Json& row) {
    return row["coverage"] == 1.0 && row["halted"] && row["ended_at_start"] && row["stack_empty"] &&
           row["map_equals_truth"];
  };
  std::string text = fmt::format("{:<44} {:>9} {:>9} {:>10} {:>8} {:>5} {:>6}\n", "maze", "reachable",
                                 "visited", "moves", "/2(C-1)", "edge", "stack");
  for (const Json& row : figures["mazes"]) {
    text +=
        row_text(row["file"].get<std::string>(), row, is_complete(row) ? "explored, home" : "NOT COMPLETE");
  }
  const Json& total = figures["total"];
  if (figures["mazes"].size() > 1) text += row_text("total", total, "");
  text += fmt::format("{} of {} mazes explored completely, home, map equal to the truth (rules: {})\n",
                      total["complete"].get<std::size_t>(), total["mazes"].get<std::size_t>(),
                      figures["rules"].get<std::string>());
  if (figures.contains("compare")) text += comparison_text(figures["compare"]);
  return text;
}

Problems check_images(const MazeExploreOptions& options) {
  Problems problems;
  if (options.files.size() > 1 && (options.svg || options.gif || options.watch)) {
    problems.push_back(
        {{}, "--svg, --gif and --watch show one maze; there are " + std::to_string(options.files.size())});
  }
  for (const auto& path : {options.svg, options.gif}) {
    if (!path) continue;
    if (!options.force && fs::exists(*path)) {
      problems.push_back({{path->string()}, "exists already; --force replaces it"});
    }
    if (path->has_parent_path() && !fs::is_directory(path->parent_path())) {
      problems.push_back({{path->parent_path().string()}, "is not a directory"});
    }
  }
  return problems;
}

/// Classic and half-size competition mazes start in the lower left corner, drawn or not.
bool has_competition_size(const GridWorld& world) {
  return world.width() == world.height() && (world.width() == 16 || world.width() == 32);
}

Result<std::vector<Maze>> read_mazes(const MazeExploreOptions& options, Console& console) {
  std::vector<Maze> mazes;
  Problems problems;
  for (const std::string& file : options.files) {
    auto read = read_maze(file);
    if (!read) {
      problems.insert(problems.end(), read.problems().begin(), read.problems().end());
      continue;
    }
    GridWorld& world = read->world;
    if (options.start) world.start = *options.start;
    if (!world.contains(world.start)) {
      problems.push_back({{file},
                          fmt::format("the start {},{} lies outside its {} x {} cells", world.start.x,
                                      world.start.y, world.width(), world.height())});
      continue;
    }
    if (!read->has_start && !options.start && read->format == MazeFormat::kText) {
      if (!has_competition_size(world)) {
        problems.push_back({{file}, "no start is drawn: mark its cell with S, or give --start x,y"});
        continue;
      }
      console.warn(fmt::format("{}: no start is drawn; starting at {},{}, as competitions do", file,
                               world.start.x, world.start.y));
    }
    if (options.svg || options.gif) {
      const Problems too_large = MazePicture{world, options.rules, file}.problems();
      problems.insert(problems.end(), too_large.begin(), too_large.end());
    }
    mazes.push_back({file, std::move(world)});
  }
  if (!problems.empty()) return problems;
  return mazes;
}

Problems draw(const MazeExploreOptions& options, const Maze& maze, Outcome& outcome) {
  const MazePicture picture{maze.world, options.rules, fs::path(maze.file).filename().string()};
  Problems problems;
  const auto write = [&](const char* role, const fs::path& path, const std::string& bytes) {
    const Problems more = write_whole_file(path, bytes);
    problems.insert(problems.end(), more.begin(), more.end());
    outcome.files[role] = path.string();
  };
  if (options.svg) write("svg", *options.svg, svg(picture));
  if (options.gif) write("gif", *options.gif, gif(picture));
  return problems;
}

Problems watch(const Terminal& terminal, const Maze& maze, GridRuleSet rules, Progress& progress) {
  MazeScreen screen(maze.world, grid_rules(rules));
  if (screen.columns() > terminal.columns || screen.rows() > terminal.rows) {
    return {{{maze.file},
             fmt::format("--watch needs a terminal of {} x {} characters; this one has {} x {}",
                         screen.columns(), screen.rows(), terminal.columns, terminal.rows)}};
  }
  do {
    progress.report("explore", 0, 0);
    terminal.show(screen.frame());
  } while (screen.step());
  return {};
}

}  // namespace

Result<Outcome> run_maze_explore(const MazeExploreOptions& options, Console& console) {
  if (Problems problems = check_images(options); !problems.empty()) return problems;
  const auto mazes = read_mazes(options, console);
  if (!mazes) return mazes.problems();
  if (options.watch) {
    Problems problems = watch(*options.watch, mazes->front(), options.rules, console.progress);
    if (!problems.empty()) return problems;
  }

  Outcome outcome{.verb = "maze explore"};
  outcome.figures = {{"rules", name_of(options.rules)}, {"mazes", Json::array()}, {"total", Json()}};
  MazeProgress progress(console.progress, mazes->size());
  Totals totals;
  Json compared = Json::object();
  for (const Maze& maze : *mazes) {
    progress.next();
    const Exploration run = explore(maze.world, maze.world.start, grid_rules(options.rules), progress);
    totals.add(run.figures);
    Json row = {{"file", maze.file},
                {"width", maze.world.width()},
                {"height", maze.world.height()},
                {"start", {maze.world.start.x, maze.world.start.y}}};
    row.update(run_figures(run.figures));
    if (options.compare) {
      row["compare"] = compare(maze, progress);
      add_moves(compared, row["compare"]);
    }
    outcome.figures["mazes"].push_back(row);
    if (Problems problems = draw(options, maze, outcome); !problems.empty()) return problems;
  }
  outcome.figures["total"] = totals.json();
  if (options.compare) outcome.figures["compare"] = compared;
  outcome.figures["cpu_s"] = rounded(process_cpu_s(), 6);
  outcome.figures["peak_rss_mb"] = rounded(process_peak_rss_mb(), 6);
  outcome.ok = totals.all_complete();
  outcome.text = exploration_text(outcome.figures);
  for (const auto& [role, path] : outcome.files) outcome.text += fmt::format("{}: {}\n", role, path);
  return outcome;
}

}  // namespace aisle
