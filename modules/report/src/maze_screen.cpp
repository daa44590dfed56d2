#include "aisle/report/maze_screen.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace aisle {
namespace {

constexpr const char* kHome = "\033[H";
constexpr const char* kClearLine = "\033[K\n";
constexpr const char* kClearRest = "\033[J";
constexpr const char* kPlain = "\033[0m";
constexpr const char* kVehicleStyle = "\033[1;97;42m";
constexpr const char* kCrossingStyle = "\033[31m";
constexpr const char* kVisitedStyle = "\033[34m";
constexpr const char* kUnderline = "\033[4m";

constexpr std::size_t kShownSymbols = 12;
constexpr int kStatusColumns = 72;
constexpr int kStatusRows = 8;

/// One character, underlined where there is a wall below, and another for the wall on its right.
std::string cell_text(char mark, const std::string& style, Sides open) {
  const char* below = contains(open, Side::kBottom) ? "" : kUnderline;
  const char* right = contains(open, Side::kRight) ? " " : "|";
  return fmt::format("{}{}{}{}{}{}{}", below, style, mark, kPlain, below, right, kPlain);
}

std::string replacement_text(const TransducerTable& table, const TransducerRule& rule) {
  if (rule.length == 0) return "epsilon";
  std::string text;
  for (int i = rule.length - 1; i >= 0; --i)
    text += table.stack[rule.replacement[static_cast<std::size_t>(i)]] + " ";
  return text;
}

std::string rule_text(const GridRules& rules, Symbol state, Symbol input, Symbol top,
                      const TransducerRule& rule) {
  const TransducerTable& table = rules.table;
  const std::string output =
      rule.output == TransducerRule::kNoOutput ? "epsilon" : table.outputs[rule.output];
  return fmt::format("rule {}: {} {} ({}) {} -> {} {} / {}", table.super_rules[rule.super_rule],
                     table.states[state], table.inputs[input], name_of(rules.inputs[input].kind),
                     table.stack[top], table.states[rule.next_state], replacement_text(table, rule), output);
}

}  // namespace

MazeScreen::MazeScreen(const GridWorld& world, const GridRules& rules)
    : world_(world),
      rules_(rules),
      explorer_(rules, world.width(), world.height(), world.start, [this](const TransducerRule& rule) {
        const auto place = static_cast<std::size_t>(&rule - rules_.table.rules.data());
        const std::size_t tops = rules_.table.tops(), inputs = rules_.table.inputs.size();
        fired_ +=
            rule_text(rules_, static_cast<Symbol>(place / tops / inputs),
                      static_cast<Symbol>(place / tops % inputs), static_cast<Symbol>(place % tops), rule) +
            kClearLine;
      }) {}

bool MazeScreen::step() {
  if (over_) return false;
  fired_.clear();
  over_ = !explorer_.step(world_.open(explorer_.at_index()));
  moves_ += !over_;
  return true;
}

int MazeScreen::columns() const {
  return std::max(4 * world_.width() + 5, kStatusColumns);
}

int MazeScreen::rows() const {
  return world_.height() + kStatusRows;
}

std::string MazeScreen::frame() const {
  std::string text = kHome;
  const std::string roof(static_cast<std::size_t>(2 * world_.width() - 1), '_');
  text += fmt::format(" {}    {} {}", roof, roof, kClearLine);
  for (int y = world_.height() - 1; y >= 0; --y) text += row(y) + kClearLine;
  return text + kClearLine + status() + kClearRest;
}

std::string MazeScreen::row(int y) const {
  std::string world = "|", map = "|";
  for (int x = 0; x < world_.width(); ++x) {
    world += world_cell({x, y});
    map += map_cell({x, y});
  }
  return world + "   " + map;
}

std::string MazeScreen::world_cell(Cell cell) const {
  const Sides open = world_.open(cell);
  const std::size_t index = world_.index(cell);
  if (explorer_.at() == cell) return cell_text('@', kVehicleStyle, open);
  if (explorer_.is_explored_crossing(index)) return cell_text('x', kCrossingStyle, open);
  if (cell == world_.start) return cell_text('o', kVisitedStyle, open);
  return cell_text(explorer_.map().visited(index) ? '.' : ' ', kVisitedStyle, open);
}

std::string MazeScreen::map_cell(Cell cell) const {
  const std::size_t index = world_.index(cell);
  if (!explorer_.map().visited(index)) return cell_text(' ', "", kEverySide);
  return cell_text(cell == world_.start ? 'o' : ' ', "", explorer_.map().open(index));
}

std::string MazeScreen::status() const {
  const TransducerTable& table = rules_.table;
  return fmt::format("moves {}, state {}{}stack of {}: {}{}{}", moves_,
                     table.states[explorer_.transducer().state()], kClearLine,
                     explorer_.transducer().stack().size() - 1, stack_text(), kClearLine, fired_);
}

/// The top of the stack, its topmost symbol last.
std::string MazeScreen::stack_text() const {
  const std::vector<Symbol>& stack = explorer_.transducer().stack();
  const std::size_t first = stack.size() - std::min(stack.size(), kShownSymbols);
  std::string text = first > 0 ? "... " : "";
  for (std::size_t i = first; i < stack.size(); ++i) text += rules_.table.stack[stack[i]] + " ";
  return text;
}

}  // namespace aisle
