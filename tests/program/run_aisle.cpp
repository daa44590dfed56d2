#include "run_aisle.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <stdexcept>

namespace aisle {
namespace {

/// A file without a name takes the program's output, because a pipe could fill up.
int make_sink(const char* name) {
  const int sink = memfd_create(name, MFD_CLOEXEC);
  if (sink < 0) throw std::runtime_error("no memory file");
  return sink;
}

std::string text_in(int sink) {
  std::string text;
  std::array<char, 1 << 16> chunk{};
  for (ssize_t count = 0;
       (count = pread(sink, chunk.data(), chunk.size(), static_cast<off_t>(text.size()))) > 0;) {
    text.append(chunk.data(), static_cast<std::size_t>(count));
  }
  return text;
}

std::string drain(int sink) {
  std::string text = text_in(sink);
  close(sink);
  return text;
}

pid_t start(const Arguments& arguments, int in, int out, int err) {
  std::vector<char*> argv = {const_cast<char*>(AISLE_PROGRAM)};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files{};
  posix_spawn_file_actions_init(&files);
  if (in >= 0) {
    posix_spawn_file_actions_adddup2(&files, in, STDIN_FILENO);
  } else {
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  }
  posix_spawn_file_actions_adddup2(&files, out, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, err, STDERR_FILENO);
  pid_t process = 0;
  const int error = posix_spawn(&process, AISLE_PROGRAM, &files, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0) throw std::runtime_error(std::string("cannot be started: ") + AISLE_PROGRAM);
  return process;
}

}  // namespace

RunningAisle::RunningAisle(const Arguments& arguments, int in)
    : out_(make_sink("stdout")), err_(make_sink("stderr")) {
  process_ = start(arguments, in, out_, err_);
}

RunningAisle::~RunningAisle() {
  if (process_ != 0) wait();
}

void RunningAisle::signal(int number) const {
  kill(process_, number);
}

std::string RunningAisle::error_so_far() const {
  return text_in(err_);
}

ProgramRun RunningAisle::wait() {
  int status = 0;
  waitpid(process_, &status, 0);
  process_ = 0;
  const int exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return {exit_code, drain(out_), drain(err_)};
}

ProgramRun run_aisle(const Arguments& arguments) {
  return RunningAisle(arguments).wait();
}

}  // namespace aisle
