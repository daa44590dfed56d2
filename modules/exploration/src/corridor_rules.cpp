#include "aisle/exploration/corridor_rules.hpp"

namespace aisle {
namespace {

/// C99 section 4.1's principles by their numbers; 5 to 7 are our additions.
enum CorridorSuperRule : Symbol { kC1, kC21, kC3, kC41, kC42, kC5, kC6, kC7 };

constexpr Symbol symbol_of(CorridorState state) {
  return static_cast<Symbol>(state);
}
constexpr Symbol symbol_of(CorridorOutput output) {
  return static_cast<Symbol>(output);
}

/// The forward operations are in the order of the bearings.
constexpr Symbol towards(Bearing bearing) {
  return static_cast<Symbol>(bearing);
}

TransducerRule keep_top(CorridorSuperRule from, CorridorState next, Symbol top,
                        Symbol output = TransducerRule::kNoOutput) {
  return {symbol_of(next), output, from, true, 1, {top}};
}

TransducerRule pop_top(CorridorSuperRule from, CorridorState next,
                       Symbol output = TransducerRule::kNoOutput) {
  return {symbol_of(next), output, from, true, 0, {}};
}

TransducerRule push_on(CorridorState state, Symbol top, Symbol pushed) {
  return {symbol_of(state), TransducerRule::kNoOutput, kC3, true, 2, {top, pushed}};
}

class CorridorRuleMaker {
 public:
  TransducerTable make() {
    name_alphabets();
    table_.rules.resize(table_.transition_rules());
    for (Symbol top = kCorridorStackStart; top <= kPathBackSymbol; ++top) {
      for (const Bearing bearing : kBearings) add_path(bearing, top);
      add_ends(top);
    }
    return std::move(table_);
  }

 private:
  TransducerRule& rule(CorridorState state, Symbol input, Symbol top) {
    return table_.rules[table_.place(symbol_of(state), input, top)];
  }

  void name_alphabets() {
    table_.states = {"q_e", "q_r", "q_fin"};
    table_.inputs = {"one-way front",     "one-way left",
                     "one-way right",     "crossing front",
                     "crossing left",     "crossing right",
                     "crossing way back", "end",
                     "explored",          "closed",
                     "detour front",      "detour left",
                     "detour right",      "away"};
    table_.stack = {"Z_0", "E_front", "E_left", "E_right", "R"};
    table_.outputs = {"forward",       "forward left",   "forward right", "backward",
                      "backward left", "backward right", "stop"};
    table_.super_rules = {"1", "2.1", "3", "4.1", "4.2", "5", "6", "7"};
    table_.start_state = symbol_of(CorridorState::kExploring);
    table_.final_state = symbol_of(CorridorState::kFinal);
    table_.start_symbol = kCorridorStackStart;
  }

  void add_path(Bearing bearing, Symbol top) {
    using enum CorridorState;
    rule(kExploring, corridor_input::one_direction(bearing), top) =
        keep_top(kC1, kExploring, top, towards(bearing));
    for (const CorridorState state : {kExploring, kRetreating}) {
      rule(state, corridor_input::crossing(bearing), top) = push_on(state, top, explore_symbol(bearing));
    }
    if (top != kCorridorStackStart)
      rule(kRetreating, corridor_input::detour(bearing), top) =
          keep_top(kC6, kExploring, top, towards(bearing));
    if (top == explore_symbol(bearing))
      rule(kRetreating, corridor_input::kExplored, top) = pop_top(kC42, kExploring, towards(bearing));
  }

  void add_ends(Symbol top) {
    using enum CorridorState;
    constexpr Symbol kBack = symbol_of(CorridorOutput::kBackward);
    rule(kExploring, corridor_input::kCrossingPathBack, top) = push_on(kExploring, top, kPathBackSymbol);
    rule(kExploring, corridor_input::kEnd, top) = keep_top(kC21, kRetreating, top);
    rule(kExploring, corridor_input::kExplored, top) = keep_top(kC41, kRetreating, top);
    if (top == kCorridorStackStart) {
      rule(kRetreating, corridor_input::kExplored, top) =
          keep_top(kC42, kFinal, top, symbol_of(CorridorOutput::kStop));
      rule(kRetreating, corridor_input::kAway, top) = keep_top(kC7, kRetreating, top, kBack);
    } else {
      rule(kRetreating, corridor_input::kClosed, top) = pop_top(kC5, kRetreating);
    }
    if (top == kPathBackSymbol)
      rule(kRetreating, corridor_input::kExplored, top) = pop_top(kC42, kRetreating, kBack);
  }

  TransducerTable table_;
};

}  // namespace

const TransducerTable& corridor_rules() {
  static const TransducerTable table = CorridorRuleMaker().make();
  return table;
}

}  // namespace aisle
