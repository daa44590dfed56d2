#include "mission_worker.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <utility>

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

/// The end of a worker, which must not do again what its parent does when it ends.
[[noreturn]] void end_worker() {
  ::_exit(EXIT_SUCCESS);
}

/// Without a signal if nobody listens any more.
bool send_all(int socket, const void* bytes, std::size_t count) {
  const char* next = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t sent = ::send(socket, next, count, MSG_NOSIGNAL);
    if (sent < 0 && errno != EINTR) return false;
    if (sent < 0) continue;
    next += sent;
    count -= static_cast<std::size_t>(sent);
  }
  return true;
}

/// One line of JSON to the parent, without which there is nothing left to do.
void say(int socket, const Json& what) {
  const std::string line = what.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  if (!send_all(socket, line.data(), line.size())) end_worker();
}

Json json_of(const Problems& problems) {
  Json list = Json::array();
  for (const Problem& problem : problems)
    list.push_back({problem.where.file, problem.where.line, problem.where.key, problem.what});
  return list;
}

Problems problems_of(const Json& list) {
  Problems problems;
  problems.reserve(list.size());
  for (const Json& one : list)
    problems.push_back({{one[0].get<std::string>(), one[1].get<long>(), one[2].get<std::string>()},
                        one[3].get<std::string>()});
  return problems;
}

/// The whole of the worker's life. It dies with its parent. Ctrl-C in the terminal reaches it as well, and is
/// the parent's to answer.
[[noreturn]] void work(const TrialMissions& missions, int socket, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) end_worker();
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_DFL);
  SilentProgress progress;
  Console console{progress, [&](const std::string& warning) { say(socket, {{"warning", warning}}); }};
  std::uint64_t mission = 0;
  try {
    while (::recv(socket, &mission, sizeof mission, MSG_WAITALL) == sizeof mission) {
      const Result<Json> record = missions.run(mission, console);
      say(socket, record ? Json{{"record", *record}} : Json{{"problems", json_of(record.problems())}});
    }
  } catch (const std::exception& error) {
    say(socket, {{"died", fmt::format("internal error: {}", error.what())}});
  }
  end_worker();
}

std::string cause_of_death(int status) {
  if (WIFSIGNALED(status))
    return fmt::format("signal {} ({})", WTERMSIG(status), ::sigdescr_np(WTERMSIG(status)));
  return fmt::format("exit code {}", WEXITSTATUS(status));
}

}  // namespace

Result<MissionWorker> MissionWorker::start(const TrialMissions& missions) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    return Problem{{"--jobs"}, fmt::format("no socket to a process for missions: {}", std::strerror(errno))};
  const pid_t parent = ::getpid();
  const pid_t process = ::fork();
  if (process == 0) {
    ::close(ends[0]);
    work(missions, ends[1], parent);
  }
  ::close(ends[1]);
  MissionWorker worker(process, ends[0]);
  if (process < 0)
    return Problem{{"--jobs"}, fmt::format("no process for missions: {}", std::strerror(errno))};
  return worker;
}

MissionWorker::MissionWorker(MissionWorker&& other) noexcept
    : process_(std::exchange(other.process_, -1)),
      socket_(std::exchange(other.socket_, -1)),
      mission_(other.mission_),
      bytes_(std::move(other.bytes_)) {}

MissionWorker& MissionWorker::operator=(MissionWorker&& other) noexcept {
  std::swap(process_, other.process_);
  std::swap(socket_, other.socket_);
  std::swap(mission_, other.mission_);
  std::swap(bytes_, other.bytes_);
  return *this;
}

MissionWorker::~MissionWorker() {
  if (process_ >= 0) {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  if (socket_ >= 0) ::close(socket_);
}

/// If the worker has died meanwhile, take() says so.
void MissionWorker::begin(std::size_t mission) {
  mission_ = mission;
  const std::uint64_t number = mission;
  send_all(socket_, &number, sizeof number);
}

std::optional<WorkerAnswer> MissionWorker::take(const Console& console) {
  std::array<char, 1 << 14> bytes{};
  while (true) {
    const ssize_t taken = ::recv(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT);
    if (taken < 0 && errno == EINTR) continue;
    if (taken < 0 && errno == EAGAIN) return std::nullopt;
    if (taken <= 0) return WorkerAnswer{.record = {}, .problems = {}, .died_of = bury()};
    bytes_.append(bytes.data(), static_cast<std::size_t>(taken));
    for (std::size_t end = bytes_.find('\n'); end != std::string::npos; end = bytes_.find('\n')) {
      const std::string line = bytes_.substr(0, end);
      bytes_.erase(0, end + 1);
      if (auto ended = said(line, console)) return ended;
    }
  }
}

std::optional<WorkerAnswer> MissionWorker::said(const std::string& line, const Console& console) {
  const Json said = Json::parse(line);
  if (said.contains("warning")) {
    console.warn(said["warning"].get<std::string>());
    return std::nullopt;
  }
  mission_.reset();
  WorkerAnswer end;
  if (said.contains("record")) end.record = said["record"];
  if (said.contains("problems")) end.problems = problems_of(said["problems"]);
  if (said.contains("died")) {
    end.died_of = said["died"].get<std::string>();
    bury();
  }
  return end;
}

/// @return what it died of
std::string MissionWorker::bury() {
  int status = 0;
  ::waitpid(std::exchange(process_, -1), &status, 0);
  mission_.reset();
  return cause_of_death(status);
}

}  // namespace aisle
