#pragma once

#include "aisle/core/clock.hpp"
#include "aisle/core/progress.hpp"

/// A bar on stderr for work that takes longer than two seconds; and the place where Ctrl-C stops the work.
class TerminalProgress final : public aisle::Progress {
 public:
  /// `visible` false: no bar, but still interruptible.
  TerminalProgress(const aisle::Clock& clock, bool visible) : clock_(clock), visible_(visible) {}
  ~TerminalProgress() override { clear(); }

  void report(std::string_view task, std::size_t done, std::size_t total) override;
  /// Takes the bar off the screen.
  void clear();

 private:
  const aisle::Clock& clock_;
  bool visible_;
  bool drawn_ = false;
  double start_s_ = 0;
  double next_draw_s_ = 0;
};

/// From now on Ctrl-C makes the next report() throw aisle::Interrupted instead of killing the program; a
/// second one kills it (it may be waiting for input that never comes).
void catch_interrupts();
