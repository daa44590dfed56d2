#include "aisle_in_terminal.hpp"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utmp.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <stdexcept>
#include <utility>
#include <vector>

namespace aisle {
namespace {

/// Normally a complete status line comes every tenth of a second; after this time without one, none will
/// come.
constexpr int kTimeout_ms = 20'000;

}  // namespace

AisleInTerminal::AisleInTerminal(const Arguments& arguments) {
  std::vector<char*> argv = {const_cast<char*>(AISLE_PROGRAM)};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  if (openpty(&keyboard_, &screen_, nullptr, nullptr, nullptr) != 0) throw std::runtime_error("no terminal");
  fcntl(keyboard_, F_SETFD, FD_CLOEXEC);
  process_ = fork();
  if (process_ < 0) throw std::runtime_error("no process");
  if (process_ == 0) {
    login_tty(screen_);
    execv(AISLE_PROGRAM, argv.data());
    _exit(127);
  }
}

AisleInTerminal::~AisleInTerminal() {
  if (process_ != 0) {
    kill(process_, SIGKILL);
    wait();
  }
  close(keyboard_);
  close(screen_);
}

void AisleInTerminal::type(std::string_view keys) const {
  const ssize_t typed = write(keyboard_, keys.data(), keys.size());
  if (typed != static_cast<ssize_t>(keys.size())) throw std::runtime_error("the terminal takes no keys");
}

std::string AisleInTerminal::next_words() const {
  constexpr int kLook_ms = 50;
  pollfd words{keyboard_, POLLIN, 0};
  for (int waited_ms = 0; waited_ms < kTimeout_ms; waited_ms += kLook_ms) {
    if (poll(&words, 1, kLook_ms) > 0) {
      std::array<char, 4096> chunk{};
      const ssize_t count = read(keyboard_, chunk.data(), chunk.size());
      return {chunk.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))};
    }
    siginfo_t end{};
    const auto process = static_cast<id_t>(process_);
    if (waitid(P_PID, process, &end, WEXITED | WNOHANG | WNOWAIT) == 0 && end.si_pid == process_) return {};
  }
  throw std::runtime_error("the program says nothing any more");
}

int AisleInTerminal::wait() {
  int status = 0;
  waitpid(std::exchange(process_, 0), &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

termios AisleInTerminal::settings() const {
  termios settings{};
  if (tcgetattr(screen_, &settings) != 0) throw std::runtime_error("no terminal any more");
  return settings;
}

}  // namespace aisle
