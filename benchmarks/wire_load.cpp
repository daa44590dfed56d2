/// What the network costs a robot's driver: the time from a scan to its command beyond what the mission
/// thinks, and the processor time for the images of a camera. The robot is a program of its own, over Cyclone
/// DDS.
///   wire_load SECONDS

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "aisle/connection/connected_vehicle.hpp"
#include "aisle/core/progress.hpp"
#include "aisle/formats/sessions/cdr.hpp"
#include "ros/messages.hpp"
#include "ros/participant.hpp"

using namespace aisle;

namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr unsigned kDomain = 71;
constexpr int kCodes = 100;  // scans and commands that are told apart
constexpr milliseconds kScanPeriod{50};
constexpr std::chrono::microseconds kImagePeriod{33333};
constexpr double kCode_m = 0.01, kCode_mps = 0.001;

double seconds_between(steady_clock::time_point from, steady_clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

robots::Time stamp_now() {
  const auto since = std::chrono::system_clock::now().time_since_epoch();
  const auto ns = std::chrono::duration_cast<std::chrono::nanoseconds>(since).count();
  return {static_cast<std::int32_t>(ns / 1'000'000'000), static_cast<std::uint32_t>(ns % 1'000'000'000)};
}

/// The robot stands; the first range of its scans is a code, which the speed of the command repeats.
class Robot {
 public:
  Robot() {
    robots::TransformStamped mount;
    mount.header.frame_id = "base_link";
    mount.child_frame_id = "laser";
    mounts_.publish({{mount}});
  }

  /// @return from the scan's sending to its command's arrival; for those that are answered at all
  std::vector<double> answer_times_s(double duration_s) {
    std::vector<double> times_s;
    std::vector<steady_clock::time_point> sent(kCodes);
    std::vector<bool> is_open(kCodes, false);
    const auto end = steady_clock::now() + std::chrono::duration<double>(duration_s);
    auto next = steady_clock::now();
    for (int code = 1; steady_clock::now() < end; code = code % (kCodes - 1) + 1) {
      sent[code] = tell(code);
      is_open[code] = true;
      next += kScanPeriod;
      while (const auto command = commands_.wait(std::max(0.0, seconds_between(steady_clock::now(), next)))) {
        const auto arrived = steady_clock::now();
        const auto answered = static_cast<std::size_t>(std::lround(command->linear.x / kCode_mps));
        if (answered >= kCodes || !is_open[answered]) continue;
        times_s.push_back(seconds_between(sent[answered], arrived));
        is_open[answered] = false;
      }
    }
    return times_s;
  }

  void send_images() {
    robots::Image image;
    image.width = image.step = 640;
    image.height = 480;
    image.encoding = "mono8";
    image.data.assign(640 * 480, 128);
    for (auto next = steady_clock::now();; std::this_thread::sleep_until(next += kImagePeriod)) {
      image.header.stamp = stamp_now();
      images_.publish(image);
    }
  }

 private:
  steady_clock::time_point tell(int code) {
    robots::Odometry odometry;
    odometry.header = {stamp_now(), "odom"};
    odometry_.publish(odometry);
    robots::LaserScan scan;
    scan.header = {odometry.header.stamp, "laser"};
    constexpr int kBeams = 360;
    scan.angle_increment = static_cast<float>(2 * M_PI / kBeams);
    scan.angle_min = static_cast<float>(-M_PI);
    scan.range_max = 12;
    scan.ranges.assign(kBeams, 3.0F);
    scan.ranges[0] = static_cast<float>(1 + kCode_m * code);
    const auto sent = steady_clock::now();
    scan_.publish(scan);
    return sent;
  }

  robots::Participant participant_{kDomain};
  robots::Publisher<robots::TFMessage> mounts_{participant_, "/tf_static", robots::Quality::kLatched};
  robots::Publisher<robots::Odometry> odometry_{participant_, "/odom", robots::Quality::kDefault};
  robots::Publisher<robots::LaserScan> scan_{participant_, "/scan", robots::Quality::kSensor};
  robots::Publisher<robots::Image> images_{participant_, "/image", robots::Quality::kSensor};
  robots::Subscription<robots::Twist> commands_{participant_, "/cmd_vel", robots::Quality::kDefault};
};

double quantile_ms(std::vector<double> times_s, double share) {
  if (times_s.empty()) return NAN;
  std::sort(times_s.begin(), times_s.end());
  return 1e3 * times_s[static_cast<std::size_t>(share * static_cast<double>(times_s.size() - 1))];
}

/// In a process of its own, which is killed at the end.
pid_t start(const std::function<void(Robot&)>& play) {
  const pid_t process = fork();
  if (process != 0) return process;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  Robot robot;
  play(robot);
  std::fflush(stdout);
  _exit(0);
}

void end(pid_t process, int signal) {
  if (signal != 0) kill(process, signal);
  waitpid(process, nullptr, 0);
}

/// The mission answers each scan at once: what is left is the network and what makes an observation of a
/// scan.
Problems answer_scans(double duration_s) {
  const pid_t robot = start([&](Robot& r) {
    const std::vector<double> times_s = r.answer_times_s(duration_s + 3);
    fmt::print("| scan to command | {} | {:.2f} | {:.2f} |\n", times_s.size(), quantile_ms(times_s, 0.5),
               quantile_ms(times_s, 0.99));
  });
  const auto connection =
      parse_connection("format: aisle.connection\nversion: 1\nvehicle: cart\n", "benchmark");
  auto wire = Wire::open({.domain = kDomain});
  if (!wire) return wire.problems();
  VehicleDescription cart;
  cart.is_differential = true;
  SteadyClock clock;
  SilentProgress progress;
  auto vehicle = ConnectedVehicle::connect(*connection, cart, {**wire, clock, progress, [](const auto&) {}});
  if (!vehicle) return vehicle.problems();
  while (const auto observation = (*vehicle)->sense()) {
    const double code = (observation->scan->ranges_m.front() - 1) / kCode_m;
    (*vehicle)->act({.speed_mps = kCode_mps * std::round(code)});
  }
  end(robot, 0);
  return {};
}

double processor_s() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Problems receive_images(double duration_s) {
  const pid_t robot = start([](Robot& r) { r.send_images(); });
  auto wire = Wire::open({.domain = kDomain});
  if (!wire) return wire.problems();
  std::atomic<int> images = 0;
  const auto subscription =
      (*wire)->subscribe("/image", robots::Image::kType, WireQuality::kSensor, [&](std::string_view bytes) {
        if (parse_cdr<ros::Image>(bytes)) ++images;
      });
  if (!subscription) return subscription.problems();
  while (images == 0) std::this_thread::sleep_for(kImagePeriod);
  images = 0;
  const double before_s = processor_s();
  std::this_thread::sleep_for(std::chrono::duration<double>(duration_s));
  const double used_s = processor_s() - before_s;
  if (duration_s > 0)
    fmt::print("| 640 x 480 mono8 received | {:.1f} Hz | {:.2f} % of a core |\n", images / duration_s,
               100 * used_s / duration_s);
  end(robot, SIGKILL);
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const double duration_s = std::stod(argv[1]);
  for (const auto& measure : {answer_scans, receive_images}) {
    const Problems problems = measure(duration_s);
    for (const Problem& problem : problems) fmt::print(stderr, "{}\n", to_string(problem));
    if (!problems.empty()) return 1;
  }
  return 0;
}
