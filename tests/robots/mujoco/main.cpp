/// A robot that knows nothing of aisle: a vehicle in MuJoCo's physics that speaks ROS 2. See ../README.md.

#include <csignal>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "pace.hpp"
#include "robot.hpp"

namespace robots {
namespace {

constexpr int kFailure = 1, kUsageFailure = 2;

volatile std::sig_atomic_t interrupted = 0;

void warn(const std::string& words) {
  std::cerr << "mujoco_robot: " << words << std::endl;
}

void warn_of_what_is_left_out(const World& world) {
  std::string names;
  for (const std::string& name : world.left_out) names += (names.empty() ? "" : ", ") + name;
  if (!names.empty()) warn("left out of the world: " + names);
}

void write_picture(const std::string& path, const ImageSize& size, const std::vector<std::uint8_t>& pixels) {
  std::ofstream file(path, std::ios::binary);
  file << "P6\n" << size.width_px << ' ' << size.height_px << "\n255\n";
  file.write(reinterpret_cast<const char*>(pixels.data()), static_cast<std::streamsize>(pixels.size()));
  if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

void write_report(const std::string& path, const Robot& robot, double wall_s) {
  nlohmann::json report = robot.report();
  report["wall_s"] = wall_s;
  report["real_time_factor"] = robot.time_s() / wall_s;
  std::ofstream file(path);
  file << report.dump(2) << '\n';
  if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

void run(const Options& options) {
  const World world = read_world(options.world);
  warn_of_what_is_left_out(world);
  const Vehicle vehicle = options.drive == "differential" ? differential_vehicle() : front_steered_vehicle();
  Robot robot(options, world, vehicle);
  if (!options.picture.empty()) write_picture(options.picture, Robot::kPictureSize, robot.seen_from_above());

  std::cout << nlohmann::json{{"ready", true}, {"vehicle", measures_of(vehicle)}} << std::endl;
  Pace pace(options.speed, options.simulated_clock);
  robot.introduce(pace.stamp(0));
  while (interrupted == 0 && (options.seconds == 0 || robot.time_s() < options.seconds)) {
    const double begin_s = robot.time_s(), end_s = begin_s + Robot::kCycle_s;
    pace.wait_for(end_s);
    robot.cycle(pace.stamp(begin_s), pace.stamp(end_s));
  }
  if (!options.report.empty()) write_report(options.report, robot, pace.wall_s());
}

}  // namespace
}  // namespace robots

int main(int argc, char** argv) {
  using namespace robots;
  std::signal(SIGTERM, [](int) { interrupted = 1; });
  std::signal(SIGINT, [](int) { interrupted = 1; });
  try {
    if (const auto options = parse_options(argc, argv)) {
      run(*options);
    } else {
      std::cout << kUsage;
    }
    return 0;
  } catch (const UsageError& error) {
    warn(error.what());
    return kUsageFailure;
  } catch (const std::exception& error) {
    warn(error.what());
    return kFailure;
  }
}
