#include "terminal_operator.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <string_view>

using namespace aisle;

namespace {

termios original_termios{};
volatile std::sig_atomic_t is_key_by_key = 0;

}  // namespace

void restore_terminal() {
  if (is_key_by_key == 0) return;
  is_key_by_key = 0;
  tcsetattr(STDIN_FILENO, TCSANOW, &original_termios);
}

KeyByKeyTerminal::KeyByKeyTerminal() {
  if (tcgetattr(STDIN_FILENO, &original_termios) != 0) return;
  termios key_by_key = original_termios;
  key_by_key.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  key_by_key.c_cc[VMIN] = 0;
  key_by_key.c_cc[VTIME] = 0;
  is_key_by_key = 1;
  tcsetattr(STDIN_FILENO, TCSANOW, &key_by_key);
}

KeyByKeyTerminal::~KeyByKeyTerminal() {
  restore_terminal();
}

TerminalOperator::TerminalOperator(const KeySpeeds& speeds, bool is_differential, bool shows_status)
    : start_s_(clock_.now_s()), controls_(speeds, is_differential), shows_status_(shows_status) {
  if (!shows_status_) return;
  fmt::print(stderr,
             "arrows drive, q stops, space ends; d NUMBER Enter: a turning begins, e: it ends, p NAME Enter: "
             "a place, x: the path ends here\n");
}

TerminalOperator::~TerminalOperator() {
  if (shows_status_) fmt::print(stderr, "\r\033[K");
}

/// Collects the keys typed until the end of the cycle; does not wait if the cycle is late.
std::vector<Key> TerminalOperator::keys_until(double time_s) {
  std::vector<Key> pressed;
  while (true) {
    const double left_s = std::max(0.0, start_s_ + time_s - clock_.now_s());
    pollfd input{STDIN_FILENO, POLLIN, 0};
    const int ready = poll(&input, 1, static_cast<int>(left_s * 1000));
    if (ready <= 0) return pressed;  // the cycle is over, or a signal came
    std::array<char, 256> bytes{};
    const ssize_t count = read(STDIN_FILENO, bytes.data(), bytes.size());
    if (count <= 0) {
      has_ended_ = true;
      return pressed;
    }
    const auto keys = keys_.read({bytes.data(), static_cast<std::size_t>(count)});
    pressed.insert(pressed.end(), keys.begin(), keys.end());
  }
}

OperatorInput TerminalOperator::look(const OperatorView& view) {
  const std::vector<Key> pressed = keys_until(view.stamp_s);
  OperatorInput input = controls_.press(view.stamp_s, pressed);
  input.quit = input.quit || has_ended_;
  show(view, input);
  return input;
}

void TerminalOperator::show(const OperatorView& view, const OperatorInput& input) {
  if (!shows_status_) return;
  for (const Mark& mark : input.marks)
    fmt::print(stderr, "\r\033[Kmark at {:.1f} s: {}\n", view.stamp_s, mark.label);
  fmt::print(stderr, "\r\033[K{:7.1f} s  {:5.2f} m/s  {}{}", view.stamp_s, view.speed_mps,
             view.bumper_pressed ? "BUMPED  " : "", keys_.typing());
  std::fflush(stderr);
}
