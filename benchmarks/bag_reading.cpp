/// How fast the laser recording is taken out of an MCAP file of images, and how much memory that needs.
///   bag_reading [MB [FOLDER]]      MB of the file before compression, 1000 by default; FOLDER for the file
/// Prints a row per compression, by processor time, which other programs disturb least. The files are warm:
/// each is read once before. `plain` reads the bytes alone.

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>

#include "aisle/formats/bags/bag_overview.hpp"
#include "aisle/formats/bags/laser_bag.hpp"
#include "bags/bag_samples.hpp"
#include "bags/bag_writers.hpp"

using namespace aisle;
namespace fs = std::filesystem;

namespace {

constexpr std::uint32_t kWidth_px = 640, kHeight_px = 480;
constexpr double kPeriod_s = 0.1;

/// A picture that can be packed to about a third, as those of cameras can.
ros::Image noisy_image(double stamp_s) {
  ros::Image image{.header = {ros::time_of(ros::stamp_ns(stamp_s)), "camera"},
                   .height = kHeight_px,
                   .width = kWidth_px,
                   .encoding = "rgb8",
                   .step = 3 * kWidth_px};
  image.data.resize(std::size_t{3} * kWidth_px * kHeight_px);
  auto state = static_cast<std::uint32_t>(1 + stamp_s * 10);
  for (std::size_t i = 0; i < image.data.size(); ++i) {
    state = state * 1664525U + 1013904223U;
    image.data[i] = static_cast<std::uint8_t>(i / 2000 % 200 + (state >> 30U));
  }
  return image;
}

ros::LaserScan room_scan(double stamp_s) {
  ros::LaserScan scan = five_beams(stamp_s);
  scan.angle_min = -static_cast<float>(M_PI);
  scan.angle_increment = static_cast<float>(M_PI / 360);
  scan.angle_max = scan.angle_min + 719 * scan.angle_increment;
  scan.ranges.assign(720, 2.5F);
  scan.intensities.assign(720, 47);
  return scan;
}

void write_recording(const fs::path& path, double megabytes, const std::string& compression) {
  std::ofstream file(path, std::ios::binary);
  McapWriter writer({.compression = compression, .chunk_messages = 24});
  std::uint64_t bytes = 0;
  for (int i = 0; static_cast<double>(bytes) < megabytes * 1e6; ++i) {
    const double stamp_s = 100 + kPeriod_s * i;
    const auto add = [&](const WrittenMessage& message) {
      bytes += message.bytes.size();
      writer.add(message);
    };
    add(written("/camera/image_raw", stamp_s, noisy_image(stamp_s)));
    add(written("/scan", stamp_s, room_scan(stamp_s)));
    for (int k = 0; k < 5; ++k) {
      const double part_s = stamp_s + 0.02 * k;
      add(written("/odom", part_s, odometry_at(part_s, 0.1 * part_s)));
      add(written("/tf", part_s, ros::TFMessage{{transform("odom", "base_link", {0.1 * part_s, 0, 0})}}));
    }
    file << writer.take();
  }
  writer.finish();
  file << writer.take();
}

struct Cost {
  double seconds = 0;
  double memory_mb = 0;
};

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Of a process of its own, so that its memory is its alone.
Cost cost_of(const std::function<bool()>& read) {
  const pid_t process = ::fork();
  if (process == 0) ::_exit(read() ? 0 : 1);
  rusage usage{};
  int status = 0;
  ::wait4(process, &status, 0, &usage);
  if (status != 0) std::exit(1);
  return {seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime),
          static_cast<double>(usage.ru_maxrss) / 1000};
}

bool read_plainly(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<char> block(std::size_t{1} << 20);
  while (file.read(block.data(), static_cast<std::streamsize>(block.size()))) {
  }
  return file.eof();
}

void measure(const fs::path& path, const std::string& compression, double megabytes) {
  write_recording(path, megabytes, compression);
  const double size_mb = static_cast<double>(fs::file_size(path)) * 1e-6;
  const auto row = [&](const char* what, const std::function<bool()>& read) {
    const Cost cost = cost_of(read);
    fmt::print("| {} | {} | {:.0f} | {:.0f} | {:.0f} | {:.0f} |\n",
               compression.empty() ? "none" : compression, what, size_mb, size_mb / cost.seconds,
               megabytes / cost.seconds, cost.memory_mb);
  };
  read_plainly(path);
  row("plain", [&] { return read_plainly(path); });
  row("laser recording", [&] { return read_laser_bag(path).ok(); });
  row("overview", [&] { return bag_overview(path).ok(); });
  fs::remove(path);
}

}  // namespace

int main(int argc, char** argv) {
  const double megabytes = argc > 1 ? std::atof(argv[1]) : 1000;
  const fs::path folder = argc > 2 ? fs::path(argv[2]) : fs::temp_directory_path();
  fmt::print(
      "| chunks | what | file (MB) | MB/s of the file | MB/s unpacked | memory (MB) "
      "|\n|---|---|---|---|---|---|\n");
  std::fflush(stdout);
  for (const char* compression : {"", "lz4", "zstd"})
    measure(folder / fmt::format("aisle-bag-reading-{}.mcap", ::getpid()), compression, megabytes);
}
