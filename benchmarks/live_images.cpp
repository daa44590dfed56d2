/// Sends 30 images of 640 x 480 pixels per second to the page in a browser. Their stamps are wall-clock time,
/// so that the page knows an image's age when it draws it. Prints the share of a core that the server's
/// thread used.
///   live_images PAGE-DIRECTORY SECONDS
/// web/tests/browser/measure.mjs runs it.

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <ctime>
#include <string>
#include <thread>

#include "aisle/formats/sessions/session_record.hpp"
#include "aisle/live/live_server.hpp"
#include "watched_vehicle.hpp"

using namespace aisle;

namespace {

constexpr std::chrono::microseconds kPeriod{33333};

double cpu_s(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Processor time of all threads but this one.
double other_cpu_s() {
  return cpu_s(CLOCK_PROCESS_CPUTIME_ID) - cpu_s(CLOCK_THREAD_CPUTIME_ID);
}

double wall_s() {
  const auto since = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration<double>(since).count();
}

Problems send_images(LiveServer& server, double duration_s) {
  auto record = SessionRecord::shown(server, watched_vehicle(), {});
  if (!record) return record.problems();
  const auto image = watched_image();
  auto next = std::chrono::steady_clock::now();
  const double begun_s = wall_s(), other_begun_s = other_cpu_s();
  while (wall_s() < begun_s + duration_s) {
    std::this_thread::sleep_until(next += kPeriod);
    Observation observation{.stamp_s = wall_s(), .odometry = FrontSteeredMotion{}};
    observation.images.push_back({"front", observation.stamp_s, image});
    if (auto kept = record->keep(std::move(observation)); !kept) return kept.problems();
  }
  if (duration_s > 0)
    fmt::print("{{\"server_share_of_a_core\":{:.4f}}}\n", (other_cpu_s() - other_begun_s) / duration_s);
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const auto server = LiveServer::open({.port = 0, .folders = {.web = argv[1]}}, {});
  if (!server) return 1;
  const double duration_s = std::stod(argv[2]);
  fmt::print(stderr, "live: {}\n", (*server)->url());
  std::fflush(stderr);
  while (duration_s > 0 && (*server)->clients() == 0) std::this_thread::sleep_for(kPeriod);
  const Problems problems = send_images(**server, duration_s);
  if (!problems.empty()) fmt::print(stderr, "{}\n", to_string(problems));
  return problems.empty() ? 0 : 1;
}
