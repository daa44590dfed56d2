#include "aisle/commands/mazes/maze_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "aisle/report/maze_symbols.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 4> kSideNames = {"left", "right", "bottom", "top"};

/// What a rule does to the stack.
enum class StackAction { kKeep, kPush, kPop };

/// Visits the table in the order of states, inputs and stack tops.
template <class Visit>
void for_each_rule(const TransducerTable& table, Visit visit) {
  for (std::size_t place = 0; place < table.rules.size(); ++place) {
    const std::size_t row = place / table.tops();
    visit(static_cast<Symbol>(row / table.inputs.size()), static_cast<Symbol>(row % table.inputs.size()),
          static_cast<Symbol>(place % table.tops()), table.rules[place]);
  }
}

std::string top_name(const TransducerTable& table, Symbol top) {
  return top == table.empty_stack() ? "empty" : table.stack[top];
}

/// The string that takes the place of the top, the new top first, as C97 writes it.
std::string replacement_text(const TransducerTable& table, const TransducerRule& rule) {
  if (rule.length == 0) return "epsilon";
  std::string text;
  for (int i = rule.length - 1; i >= 0; --i) {
    text += table.stack[rule.replacement[static_cast<std::size_t>(i)]];
    if (i > 0) text += ' ';
  }
  return text;
}

std::string output_name(const TransducerTable& table, const TransducerRule& rule) {
  return rule.output == TransducerRule::kNoOutput ? "epsilon" : table.outputs[rule.output];
}

Json side_names(Sides sides) {
  Json names = Json::array();
  for (const Side side : kAllSides) {
    if (contains(sides, side)) names.push_back(kSideNames[static_cast<std::size_t>(side)]);
  }
  return names;
}

Json counts_of(const TransducerTable& table) {
  const auto count = [&](auto holds) { return std::count_if(table.rules.begin(), table.rules.end(), holds); };
  return {{"states", table.states.size()},
          {"inputs", table.inputs.size()},
          {"stack_symbols", table.stack.size()},
          {"outputs", table.outputs.size()},
          {"transition_rules", table.transition_rules()},
          {"output_rules", table.output_rules()},
          {"defined_rules", count([](const TransducerRule& rule) { return rule.defined(); })},
          {"reachable_rules", count([](const TransducerRule& rule) { return rule.reachable; })}};
}

Json inputs_json(const GridRules& rules) {
  Json inputs = Json::array();
  for (std::size_t i = 0; i < rules.inputs.size(); ++i) {
    const GridInput& input = rules.inputs[i];
    Json came_from;
    if (input.came_from) came_from = kSideNames[static_cast<std::size_t>(*input.came_from)];
    inputs.push_back({{"name", rules.table.inputs[i]},
                      {"kind", name_of(input.kind)},
                      {"came_from", came_from},
                      {"open", side_names(input.open)},
                      {"false_walls", side_names(input.false_walls)}});
  }
  return inputs;
}

Json transition_json(const TransducerTable& table, const TransducerRule& rule, Json row) {
  row["reachable"] = rule.reachable;
  row["super_rule"] = rule.defined() ? Json(table.super_rules[rule.super_rule]) : Json();
  row["next_state"] = rule.defined() ? Json(table.states[rule.next_state]) : Json();
  if (!rule.defined()) {
    row["replacement"] = Json();
    return row;
  }
  row["replacement"] = Json::array();
  for (int i = rule.length - 1; i >= 0; --i) {
    row["replacement"].push_back(table.stack[rule.replacement[static_cast<std::size_t>(i)]]);
  }
  return row;
}

Json output_json(const TransducerTable& table, const TransducerRule& rule, Json row) {
  row["reachable"] = rule.reachable;
  row["super_rule"] = rule.defined() ? Json(table.super_rules[rule.super_rule]) : Json();
  row["output"] = rule.output == TransducerRule::kNoOutput ? Json() : Json(table.outputs[rule.output]);
  return row;
}

Json table_json(const GridRules& rules) {
  const TransducerTable& table = rules.table;
  Json transitions = Json::array(), outputs = Json::array();
  for_each_rule(table, [&](Symbol state, Symbol input, Symbol top, const TransducerRule& rule) {
    const Json row = {
        {"state", table.states[state]}, {"input", table.inputs[input]}, {"top", top_name(table, top)}};
    transitions.push_back(transition_json(table, rule, row));
    if (table.has_output_rule(state, top)) outputs.push_back(output_json(table, rule, row));
  });
  return {{"rules", name_of(rules.set)},     {"counts", counts_of(table)}, {"states", table.states},
          {"stack_symbols", table.stack},    {"outputs", table.outputs},   {"inputs", inputs_json(rules)},
          {"transition_rules", transitions}, {"output_rules", outputs}};
}

std::string table_text(const GridRules& rules) {
  const TransducerTable& table = rules.table;
  const Json counts = counts_of(table);
  std::string text = fmt::format(
      "rules {}: {} inputs, {} stack symbols, {} states, {} outputs\n{} transition rules, {} output rules; "
      "{} are given "
      "by a super rule, {} are reachable\n\nstate  input top    super rule  state  stack                "
      "output\n",
      name_of(rules.set), table.inputs.size(), table.stack.size(), table.states.size(), table.outputs.size(),
      table.transition_rules(), table.output_rules(), counts["defined_rules"].dump(),
      counts["reachable_rules"].dump());
  for_each_rule(table, [&](Symbol state, Symbol input, Symbol top, const TransducerRule& rule) {
    text += fmt::format("{:<6} {:<5} {:<6} ", table.states[state], table.inputs[input], top_name(table, top));
    if (!rule.defined()) {
      text += "-           unreachable\n";
      return;
    }
    text += fmt::format("{:<11} {:<6} {:<20} {:<7}{}\n", table.super_rules[rule.super_rule],
                        table.states[rule.next_state], replacement_text(table, rule),
                        output_name(table, rule), rule.reachable ? "" : " unreachable");
  });
  return text;
}

StackAction stack_action(const TransducerRule& rule) {
  if (rule.length > 1) return StackAction::kPush;
  return rule.length == 0 ? StackAction::kPop : StackAction::kKeep;
}

std::string stack_action_text(StackAction action) {
  constexpr std::array<const char*, 3> kTexts = {"", ", push", ", pop"};
  return kTexts[static_cast<std::size_t>(action)];
}

/// One edge per pair of states, labelled with super rules and kinds of input, each with its number of
/// reachable rules.
std::string table_dot(const GridRules& rules) {
  const TransducerTable& table = rules.table;
  using Cause = std::tuple<Symbol, GridInputKind, StackAction>;
  std::map<std::pair<Symbol, Symbol>, std::map<Cause, std::size_t>> edges;
  for_each_rule(table, [&](Symbol state, Symbol input, Symbol, const TransducerRule& rule) {
    if (!rule.reachable) return;
    ++edges[{state, rule.next_state}][{rule.super_rule, rules.inputs[input].kind, stack_action(rule)}];
  });
  std::string text = fmt::format(
      "digraph \"{}\" {{\n  rankdir=LR;\n  nodesep=1;\n  node [shape=circle, fontname=\"DejaVu Sans\"];\n"
      "  edge [fontname=\"DejaVu Sans\", fontsize=11];\n  start [shape=point];\n  start -> {};\n",
      name_of(rules.set), table.states[table.start_state]);
  text += fmt::format("  {} [shape=doublecircle];\n", table.states[table.final_state]);
  for (const auto& [ends, causes] : edges) {
    std::string label;
    for (const auto& [cause, count] : causes) {
      const auto& [super_rule, kind, action] = cause;
      label += fmt::format("{}: {}{} ({})\\l", table.super_rules[super_rule], name_of(kind),
                           stack_action_text(action), count);
    }
    text += fmt::format("  {} -> {} [label=\"{}\"];\n", table.states[ends.first], table.states[ends.second],
                        label);
  }
  return text + "}\n";
}

std::string text_of(const GridRules& rules, MazeTableFormat format) {
  switch (format) {
    case MazeTableFormat::kText:
      return table_text(rules);
    case MazeTableFormat::kJson:
      return table_json(rules).dump(1) + "\n";
    case MazeTableFormat::kDot:
      return table_dot(rules);
    case MazeTableFormat::kSvg:
      return input_symbols_svg(rules);
  }
  return {};
}

}  // namespace

Result<Outcome> run_maze_table(const MazeTableOptions& options, Console&) {
  const GridRules& rules = grid_rules(options.rules);
  Outcome outcome{.verb = "maze table"};
  outcome.figures = table_json(rules);
  outcome.text = text_of(rules, options.format);
  return outcome;
}

}  // namespace aisle
