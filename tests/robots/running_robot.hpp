#pragma once

#include <sys/types.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace robots {

/// A program as a child process: started by the constructor, killed by the destructor, and by the end of this
/// process.
class RunningRobot {
 public:
  /// @param program  its path; empty: mujoco_robot
  explicit RunningRobot(const std::vector<std::string>& arguments, std::string program = {});
  /// Starts robot_person: somebody who drives a robot along a world's tour, with /cmd_vel or a joystick.
  static RunningRobot person(const std::string& world, unsigned domain, bool by_joystick);
  ~RunningRobot();
  RunningRobot(const RunningRobot&) = delete;
  RunningRobot& operator=(const RunningRobot&) = delete;

  /// @return the vehicle's measures, as the robot prints them. Throws std::runtime_error if it ends instead,
  /// or is not ready after a minute.
  nlohmann::json wait_until_ready() const;
  void signal(int number) const;
  /// Asks it to end. @return as wait()
  int stop();
  /// @return its exit code; negative: it was killed
  int wait();

 private:
  pid_t process_;
  int output_;
};

/// A domain that no other test is likely to be in at the same time.
/// @param offset  0 to 79, for tests that need several
unsigned domain_of_this_process(unsigned offset = 0);

}  // namespace robots
