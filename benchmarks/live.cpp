/// What it costs a mission's cycle to have viewers: recorded for nobody, and shown to ten clients, one of
/// which reads nothing. Processor time of the mission's thread alone.

#include <benchmark/benchmark.h>

#include <ctime>
#include <memory>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "aisle/formats/sessions/session_record.hpp"
#include "aisle/live/live_server.hpp"
#include "live_client.hpp"
#include "watched_vehicle.hpp"

using namespace aisle;

namespace {

constexpr int kClients = 10;

class Nobody final : public MessageSink {
 public:
  void take(const SessionTopic&, ros::Stamp_ns, std::string_view) override {}
};

double thread_cpu_s() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// A client that reads everything it gets, on its own thread.
std::jthread reading_client(std::uint16_t port) {
  return std::jthread([port](const std::stop_token& stop) {
    LiveClient client(port);
    client.subscribe_to_all();
    while (!stop.stop_requested()) {
      client.read();
      client.messages.clear();
    }
  });
}

SessionRecord record_for(MessageSink& watcher) {
  auto record = SessionRecord::shown(watcher, watched_vehicle(), {});
  if (!record) throw std::runtime_error(to_string(record.problems()));
  return std::move(*record);
}

/// Cycles of one mission, one after the other.
class Cycles {
 public:
  explicit Cycles(MessageSink& watcher) : record_(record_for(watcher)) {}

  double drive_one() {
    stamp_s_ += 1.0 / 30;
    const double begun_s = thread_cpu_s();
    Observation observation{.stamp_s = stamp_s_, .odometry = FrontSteeredMotion{}};
    observation.images.push_back({"front", stamp_s_, image_});
    if (!record_.keep(std::move(observation))) throw std::runtime_error("a cycle was not shown");
    (void)record_.keep(Decision{.state = "driving"});
    return thread_cpu_s() - begun_s;
  }

 private:
  SessionRecord record_;
  std::shared_ptr<const Image> image_ = watched_image();
  double stamp_s_ = 0;
};

void for_nobody(benchmark::State& state) {
  Nobody nobody;
  Cycles cycles(nobody);
  for (auto _ : state) state.SetIterationTime(cycles.drive_one());
}
BENCHMARK(for_nobody)->UseManualTime()->Unit(benchmark::kMicrosecond);

void for_ten_clients_one_stalled(benchmark::State& state) {
  auto server = LiveServer::open({.port = 0}, {});
  if (!server) return state.SkipWithError("no server");
  Cycles cycles(**server);
  cycles.drive_one();  // now the channels are known
  LiveClient stalled((*server)->port());
  stalled.subscribe_to_all();
  std::vector<std::jthread> clients;
  for (int i = 1; i < kClients; ++i) clients.push_back(reading_client((*server)->port()));
  while ((*server)->clients() < kClients) std::this_thread::yield();
  for (auto _ : state) {
    state.SetIterationTime(cycles.drive_one());
    (*server)->take_time(1);
  }
  for (std::jthread& client : clients) client.request_stop();
  cycles.drive_one();
  (*server)->take_time(2);
}
BENCHMARK(for_ten_clients_one_stalled)->UseManualTime()->Unit(benchmark::kMicrosecond);

}  // namespace
