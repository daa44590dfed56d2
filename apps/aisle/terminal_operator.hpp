#pragma once

#include <termios.h>

#include "aisle/core/clock.hpp"
#include "aisle/guidance/key_controls.hpp"
#include "aisle/simulation/operators/operator.hpp"

/// While this lives, the terminal on stdin delivers every key at once and echoes none. The terminal is
/// restored however the program ends, by a signal too.
class KeyByKeyTerminal {
 public:
  KeyByKeyTerminal();
  ~KeyByKeyTerminal();
  KeyByKeyTerminal(const KeyByKeyTerminal&) = delete;
  KeyByKeyTerminal& operator=(const KeyByKeyTerminal&) = delete;
};

/// Restores the terminal's mode if it was changed. May be called from a signal handler.
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
  bool has_ended_ = false;  ///< stdin is closed: no more keys will come
};
