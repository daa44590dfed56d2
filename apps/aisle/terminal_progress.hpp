#pragma once

#include "aisle/core/clock.hpp"
#include "aisle/core/progress.hpp"

/// A progress bar on stderr for work that takes longer than two seconds; Ctrl-C stops the work in report().
class TerminalProgress final : public aisle::Progress {
 public:
  /// `visible` false: no bar, but still interruptible.
  TerminalProgress(const aisle::Clock& clock, bool visible) : clock_(clock), visible_(visible) {}
  ~TerminalProgress() override { clear(); }

  void report(std::string_view task, std::size_t done, std::size_t total) override;
  /// Removes the bar from the screen.
  void clear();

 private:
  const aisle::Clock& clock_;
  bool visible_;
  bool drawn_ = false;
  double start_s_ = 0;
  double next_draw_s_ = 0;
};

/// From now on Ctrl-C makes the next report() throw aisle::Interrupted instead of killing the program. A
/// second Ctrl-C kills it, since it may be waiting for input that never comes.
void catch_interrupts();
