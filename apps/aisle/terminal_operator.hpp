#pragma once

#include <termios.h>

#include "aisle/core/clock.hpp"
#include "aisle/guidance/key_controls.hpp"
#include "aisle/simulation/operators/operator.hpp"

/// The terminal on stdin gives every key at once and shows none, as long as this lives; whatever ends the
/// program, signals too, the terminal is as it was before.
class KeyByKeyTerminal {
 public:
  KeyByKeyTerminal();
  ~KeyByKeyTerminal();
  KeyByKeyTerminal(const KeyByKeyTerminal&) = delete;
  KeyByKeyTerminal& operator=(const KeyByKeyTerminal&) = delete;
};

/// Gives the terminal back, if it was taken. May be called from a signal handler.
void restore_terminal();

/// A person at the keys of the terminal on stdin, in real time; a status line on stderr.
class TerminalOperator final : public aisle::Operator {
 public:
  TerminalOperator(const aisle::KeySpeeds& speeds, bool is_differential, bool shows_status);
  ~TerminalOperator() override;

  aisle::OperatorInput look(const aisle::OperatorView& view) override;

 private:
  std::vector<aisle::Key> keys_until(double time_s);
  void show(const aisle::OperatorView& view, const aisle::OperatorInput& input);

  KeyByKeyTerminal terminal_;
  aisle::SteadyClock clock_;
  double start_s_;
  aisle::TerminalKeys keys_;
  aisle::KeyControls controls_;
  bool shows_status_;
  bool has_ended_ = false;  ///< no keys can come any more
};
