#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "aisle/commands/convert.hpp"
#include "aisle/formats/worlds/world_yaml.hpp"
#include "aisle/geometry/polyline.hpp"
#include "aisle/simulation/obstacles.hpp"
#include "aisle/simulation/paths/free_floor.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

namespace {

constexpr std::size_t kPixelsMax = 40'000;

/// A folder in memory, because every input is written and read.
std::filesystem::path make_folder() {
  const std::filesystem::path memory = "/dev/shm";
  std::error_code error;
  const auto base =
      std::filesystem::is_directory(memory, error) ? memory : std::filesystem::temp_directory_path();
  const auto folder = base / ("aisle-fuzz-plan-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  return folder;
}

/// OpenCV, librsvg and pdftocairo read the other kinds; their own fuzzers are better at it.
bool is_read_by_aisle(std::string_view text) {
  if (text.starts_with("\x89PNG") || text.starts_with("\xff\xd8\xff") || text.starts_with("RIFF"))
    return false;
  if (text.starts_with("BM") || text.starts_with("II*") || text.starts_with("MM")) return false;
  if (text.starts_with("P3") || text.starts_with("P6")) return false;
  return text.find("<svg") == std::string_view::npos && !text.starts_with("%PDF");
}

/// What exploring asks of a world before it begins.
void look_around(const World& world) {
  if (!world.start) return;
  const auto obstacles = obstacles_below(world, 2);
  const FreeFloor floor(obstacles, world.start->position(), 0.3);
  require(floor.area_m2() >= 0);
}

}  // namespace

/// A plan becomes a world with a tour, which is written, read again, and looked at as exploring does.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const auto folder = make_folder();
  const std::string_view text = fuzz_text(bytes, size);
  if (!is_read_by_aisle(text)) return 0;
  const auto pixels = parse_plan_pixels(text, "input");
  if (pixels && pixels->image.bytes.size() > kPixelsMax) return 0;  // the same, only slower
  std::ofstream(folder / "plan", std::ios::binary) << text;
  SilentProgress silent;
  Console console{silent, [](const std::string&) {}};
  ConvertOptions options;
  options.plan = folder / "plan";
  options.out = folder / "world.yaml";
  options.force = true;
  const auto outcome = run_convert(options, console);
  if (!outcome) {
    require(!outcome.problems().empty());
    return 0;
  }
  const auto world = read_world(options.out);
  require(world.ok() && !world->walls.empty());
  require(std::isfinite(polyline_length_m(world->tour)) && polyline_length_m(world->tour) < 1e7);
  look_around(*world);
  return 0;
}
