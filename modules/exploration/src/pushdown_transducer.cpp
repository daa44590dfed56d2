#include "aisle/exploration/pushdown_transducer.hpp"

#include <stdexcept>

namespace aisle {

void TransducerRun::replace_top(const TransducerRule& rule) {
  if (!stack_.empty()) stack_.pop_back();
  stack_.insert(stack_.end(), rule.replacement.begin(), rule.replacement.begin() + rule.length);
}

void TransducerRun::throw_undefined(Symbol input) const {
  const std::string top_name = stack_.empty() ? "an empty stack" : table_->stack[top()];
  throw std::logic_error("no rule for state " + table_->states[state_] + ", input " +
                         table_->inputs.at(input) + ", top " + top_name);
}

}  // namespace aisle
