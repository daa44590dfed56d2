#include "running_robot.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>
#include <utility>

namespace robots {

RunningRobot RunningRobot::person(const std::string& world, unsigned domain, bool by_joystick) {
  std::vector<std::string> arguments = {world, std::to_string(domain)};
  if (by_joystick) arguments.emplace_back("--joy");
  return RunningRobot(arguments, ROBOT_PERSON);
}

RunningRobot::RunningRobot(const std::vector<std::string>& arguments, std::string program) {
  if (program.empty()) program = MUJOCO_ROBOT;
  std::vector<char*> argv = {program.data()};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  process_ = fork();
  if (process_ < 0) throw std::runtime_error("no process");
  if (process_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    dup2(ends[1], STDOUT_FILENO);
    execv(program.c_str(), argv.data());
    _exit(127);
  }
  close(ends[1]);
  output_ = ends[0];
}

RunningRobot::~RunningRobot() {
  if (process_ != 0) {
    kill(process_, SIGKILL);
    wait();
  }
  close(output_);
}

nlohmann::json RunningRobot::wait_until_ready() const {
  constexpr int kTimeout_ms = 60'000;
  std::string line;
  for (char letter = 0; letter != '\n'; line += letter) {
    pollfd output{output_, POLLIN, 0};
    if (poll(&output, 1, kTimeout_ms) != 1) throw std::runtime_error("the robot says nothing");
    if (read(output_, &letter, 1) != 1) throw std::runtime_error("the robot ended before it was ready");
  }
  return nlohmann::json::parse(line).at("vehicle");
}

void RunningRobot::signal(int number) const {
  kill(process_, number);
}

int RunningRobot::stop() {
  signal(SIGTERM);
  return wait();
}

int RunningRobot::wait() {
  int status = 0;
  waitpid(std::exchange(process_, 0), &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

unsigned domain_of_this_process(unsigned offset) {
  constexpr unsigned kFirst = 20, kCount = 80;
  return kFirst + (static_cast<unsigned>(getpid()) + offset) % kCount;
}

}  // namespace robots
