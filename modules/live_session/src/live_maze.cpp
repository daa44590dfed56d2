#include "live_maze.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "aisle/exploration/exploration_run.hpp"
#include "aisle/exploration/grid_explorer.hpp"
#include "aisle/formats/mazes/maze_file.hpp"

namespace aisle {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr int kCellsMax = 64;  ///< along a side
constexpr std::size_t kStepsMax = 40'000;

constexpr char letter_of(Side side) {
  constexpr std::string_view kLetters = "WESN";  // in the order of Side
  return kLetters[static_cast<std::size_t>(side)];
}

std::string letters_of(Sides sides) {
  std::string letters;
  for (const Side side : kAllSides) {
    if (contains(sides, side)) letters += letter_of(side);
  }
  return letters;
}

struct MazeRun {
  GridWorld world;
  const GridRules& rules;
};

Result<MazeRun> read_run(const nlohmann::json& arguments) {
  const auto text_at = [&](const char* key) {
    const auto found = arguments.find(key);
    return found != arguments.end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  const std::string named = text_at("rules");
  const auto set = named.empty() ? GridRuleSet::kPublished : grid_rule_set(named);
  if (!set) return Problem{{"", 0, "rules"}, "must be published, shortcut, cells, homing or roaming"};
  auto maze = parse_maze(text_at("maze"), "maze");
  if (!maze) return maze.problems();
  GridWorld& world = maze->world;
  if (world.width() > kCellsMax || world.height() > kCellsMax)
    return Problem{{"maze"}, fmt::format("has more than {0} x {0} cells", kCellsMax)};
  return MazeRun{std::move(world), grid_rules(*set)};
}

OrderedJson cell_json(Cell cell) {
  return {cell.x, cell.y};
}

OrderedJson names_of(const TransducerTable& table, const std::vector<Symbol>& stack) {
  OrderedJson names = OrderedJson::array();
  for (const Symbol symbol : stack) names.push_back(table.stack[symbol]);
  return names;
}

OrderedJson step_json(GridExplorer& explorer, Sides open, std::string& fired) {
  const TransducerTable& table = explorer.rules().table;
  const OrderedJson cell = cell_json(explorer.at());
  fired.clear();
  const auto move = explorer.step(open);
  const GridInput& input = explorer.rules().inputs[explorer.last_input()];
  return {{"cell", cell},
          {"open", letters_of(open)},
          {"input", table.inputs[explorer.last_input()]},
          {"input_kind", name_of(input.kind)},
          {"input_open", letters_of(input.open)},
          {"rule", fired},
          {"state", table.states[explorer.transducer().state()]},
          {"move", move ? std::string(1, letter_of(*move)) : ""},
          {"stack", names_of(table, explorer.transducer().stack())}};
}

}  // namespace

Result<OrderedJson> maze_steps(const nlohmann::json& arguments) {
  const auto run = read_run(arguments);
  if (!run) return run.problems();
  const auto& [world, rules] = *run;
  const TransducerTable& table = rules.table;
  std::string fired;
  const auto note = [&fired, &table](const TransducerRule& rule) {
    fired += (fired.empty() ? "" : ", ") + table.super_rules[rule.super_rule];
  };
  GridExplorer explorer(rules, world.width(), world.height(), world.start, note);
  OrderedJson steps = OrderedJson::array();
  while (steps.size() < kStepsMax) {
    steps.push_back(step_json(explorer, world.open(explorer.at_index()), fired));
    if (steps.back()["move"].get<std::string>().empty()) break;
  }
  SilentProgress silent;
  const ExplorationFigures figures = explore(world, world.start, rules, silent).figures;
  return OrderedJson{{"width", world.width()},
                     {"height", world.height()},
                     {"start", cell_json(world.start)},
                     {"rules", name_of(rules.set)},
                     {"states", table.states},
                     {"stack_symbols", table.stack},
                     {"steps", std::move(steps)},
                     {"figures",
                      {{"reachable", figures.reachable},
                       {"visited", figures.visited},
                       {"moves", figures.moves},
                       {"max_edge_uses", figures.max_edge_uses},
                       {"max_stack", figures.max_stack},
                       {"complete", figures.complete()}}}};
}

}  // namespace aisle
