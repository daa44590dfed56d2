#pragma once
/// Pushdown transducers as data (C97 section 3.1): M = (Q, Sigma, Gamma, Delta, delta, lambda, q0, Z0).
/// Independent of grids, vehicles and exploration.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace aisle {

/// The position of a state or symbol in its alphabet.
using Symbol = std::uint8_t;

/// delta and lambda for one state, input and stack top.
struct TransducerRule {
  static constexpr Symbol kNoOutput = 255;
  static constexpr Symbol kNone = 255;  ///< `super_rule` of a combination that no rule covers

  Symbol next_state = 0;
  Symbol output = kNoOutput;            ///< kNoOutput: the machine goes on without an action
  Symbol super_rule = kNone;            ///< the super rule that it follows from
  bool reachable = false;               ///< whether any world leads to this combination
  Symbol length = 0;                    ///< of `replacement`
  std::array<Symbol, 4> replacement{};  ///< replaces the stack's top symbol; the last one is the new top

  bool defined() const { return super_rule != kNone; }
};

/// The eight-tuple. States and symbols are numbered by their position in these lists.
struct TransducerTable {
  std::vector<std::string> states;
  std::vector<std::string> inputs;
  std::vector<std::string> stack;
  std::vector<std::string> outputs;
  std::vector<std::string> super_rules;
  Symbol start_state = 0;
  Symbol final_state = 0;
  Symbol start_symbol = 0;
  std::vector<TransducerRule> rules;  ///< [state][input][stack top]; the last top is the empty stack

  std::size_t tops() const { return stack.size() + 1; }
  Symbol empty_stack() const { return static_cast<Symbol>(stack.size()); }
  std::size_t place(Symbol state, Symbol input, Symbol top) const {
    return (state * inputs.size() + input) * tops() + top;
  }
  const TransducerRule& rule(Symbol state, Symbol input, Symbol top) const {
    return rules[place(state, input, top)];
  }

  /// Sizes of delta and lambda as C97 counts them: delta for every state, and for an empty stack too; lambda
  /// for the states that do not end the run, with something on the stack.
  std::size_t transition_rules() const { return states.size() * inputs.size() * tops(); }
  std::size_t output_rules() const { return (states.size() - 1) * inputs.size() * stack.size(); }
  bool has_output_rule(Symbol state, Symbol top) const {
    return state != final_state && top != empty_stack();
  }
};

/// One run of a transducer. The table must outlive it.
class TransducerRun {
 public:
  explicit TransducerRun(const TransducerTable& table)
      : table_(&table),
        state_(table.start_state),
        stack_{table.start_symbol},
        tops_(table.tops()),
        inputs_(table.inputs.size()) {}

  /// Takes one input. A combination without a rule throws std::logic_error and changes nothing.
  const TransducerRule& step(Symbol input) {
    const Symbol before = top();
    const TransducerRule& rule = table_->rules[(state_ * inputs_ + input) * tops_ + before];
    if (!rule.defined()) throw_undefined(input);
    state_ = rule.next_state;
    if (rule.length == 1 && !stack_.empty()) {
      stack_.back() = rule.replacement[0];
    } else {
      replace_top(rule);
    }
    return rule;
  }

  Symbol state() const { return state_; }
  Symbol top() const { return stack_.empty() ? table_->empty_stack() : stack_.back(); }
  /// From the bottom, with the start symbol.
  const std::vector<Symbol>& stack() const { return stack_; }
  bool halted() const { return state_ == table_->final_state; }

 private:
  void replace_top(const TransducerRule& rule);
  [[noreturn]] void throw_undefined(Symbol input) const;

  const TransducerTable* table_;
  Symbol state_;
  std::vector<Symbol> stack_;
  std::size_t tops_;
  std::size_t inputs_;
};

}  // namespace aisle
