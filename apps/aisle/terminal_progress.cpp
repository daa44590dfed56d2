#include "terminal_progress.hpp"

#include <fmt/format.h>

#include <csignal>

#include "terminal_operator.hpp"

namespace {

constexpr double kShownAfter_s = 2;
constexpr double kRedrawn_s = 0.1;
constexpr std::size_t kWidth = 30;

volatile std::sig_atomic_t interrupted = 0;

void on_second_interrupt(int signal) {
  restore_terminal();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void on_interrupt(int signal) {
  interrupted = 1;
  std::signal(signal, on_second_interrupt);
}

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
}

void TerminalProgress::report(std::string_view task, std::size_t done, std::size_t total) {
  if (interrupted) throw aisle::Interrupted{};
  if (!visible_ || total == 0) return;
  const double now_s = clock_.now_s();
  if (start_s_ == 0) start_s_ = now_s;
  if (now_s - start_s_ < kShownAfter_s || now_s < next_draw_s_) return;
  next_draw_s_ = now_s + kRedrawn_s;
  const std::size_t filled = kWidth * done / total;
  fmt::print(stderr, "\r{:<12} [{}{}] {:3d} %", task, std::string(filled, '='),
             std::string(kWidth - filled, ' '), 100 * done / total);
  std::fflush(stderr);
  drawn_ = true;
}

void TerminalProgress::clear() {
  if (!drawn_) return;
  fmt::print(stderr, "\r\033[K");
  drawn_ = false;
}
