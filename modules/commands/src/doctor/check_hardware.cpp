#include <fcntl.h>
#include <fmt/format.h>
#include <sys/timex.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <system_error>
#include <thread>

#include "machine_check.hpp"

namespace aisle {
namespace {

/// /proc/meminfo in bytes, by name.
std::map<std::string, double> memory_bytes() {
  std::ifstream lines("/proc/meminfo");
  std::map<std::string, double> sizes;
  std::string name;
  std::string unit;
  for (double size_kib = 0; lines >> name >> size_kib && std::getline(lines, unit);)
    sizes[name.substr(0, name.size() - 1)] = size_kib * 1024;
  return sizes;
}

std::vector<std::filesystem::path> video_devices() {
  std::vector<std::filesystem::path> devices;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/dev", error))
    if (entry.path().filename().string().starts_with("video")) devices.push_back(entry.path());
  std::sort(devices.begin(), devices.end());
  return devices;
}

}  // namespace

MachineCheck check_cores() {
  const unsigned cores = std::thread::hardware_concurrency();
  return {.name = "processor",
          .found = fmt::format("{} core{} for this program", cores, cores == 1 ? "" : "s")};
}

MachineCheck check_memory() {
  const auto sizes = memory_bytes();
  const auto total = sizes.find("MemTotal");
  const auto available = sizes.find("MemAvailable");
  if (total == sizes.end() || available == sizes.end())
    return {.name = "memory",
            .state = MachineState::kLimited,
            .found = "not known: /proc/meminfo cannot be read",
            .advice = "mount /proc"};
  return {
      .name = "memory",
      .found = fmt::format("{:.1f} of {:.1f} GB available", available->second / 1e9, total->second / 1e9)};
}

MachineCheck check_cameras() {
  MachineCheck check{.name = "cameras"};
  bool is_any_refused = false;
  for (const std::filesystem::path& device : video_devices()) {
    const bool can_open = access(device.c_str(), R_OK | W_OK) == 0;
    check.found += fmt::format("{}{}{}", check.found.empty() ? "" : ", ", device.string(),
                               can_open ? "" : fmt::format(" ({})", std::strerror(errno)));
    is_any_refused = is_any_refused || !can_open;
  }
  if (check.found.empty())
    check.found = "no device /dev/video*; cameras of the network and of a robot need none";
  if (is_any_refused) {
    check.state = MachineState::kLimited;
    check.advice = "adduser NAME video, and log in again";
  }
  return check;
}

MachineCheck check_clock() {
  timex clock{};
  const int state = adjtimex(&clock);
  const bool is_kept =
      state >= 0 && state != TIME_ERROR && (static_cast<unsigned>(clock.status) & STA_UNSYNC) == 0U;
  if (is_kept)
    return {.name = "clock",
            .found = fmt::format("kept by a time server, wrong by {:.1f} ms at most",
                                 static_cast<double>(clock.maxerror) / 1000)};  // from microseconds
  return {
      .name = "clock",
      .state = MachineState::kLimited,
      .found =
          "no time server keeps it, as far as the kernel knows: stamps of another machine may seem too old",
      .advice =
          "apt install systemd-timesyncd, here and on the robot; not needed where all run on one machine"};
}

}  // namespace aisle
