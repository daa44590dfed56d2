#include <cmath>

#include "aisle/commands/convert.hpp"
#include "aisle/formats/images/plan_image.hpp"
#include "aisle/formats/worlds/world_yaml.hpp"
#include "aisle/geometry/polyline.hpp"
#include "aisle/simulation/cross_section.hpp"
#include "aisle/simulation/paths/free_floor.hpp"
#include "fuzz_file.hpp"

using namespace aisle;

namespace {

constexpr std::size_t kPixelsMax = 40'000;  // more of them are the same, only slower ...
constexpr double kWallsMax_m = 200;         // ... and so are longer walls

/// Other kinds are read by OpenCV, librsvg and pdftocairo, whose own fuzzers are better at it.
bool is_read_by_aisle(std::string_view text) {
  for (const std::string_view other :
       {"\x89PNG", "\xff\xd8\xff", "RIFF", "BM", "II*", "MM", "P3", "P6", "%PDF"})
    if (text.starts_with(other)) return false;
  return text.find("<svg") == std::string_view::npos;
}

bool is_small(std::string_view text) {
  const auto pixels = parse_plan_pixels(text, "input");
  if (pixels && pixels->image.bytes.size() > kPixelsMax) return false;
  double walls_m = 0;
  if (const auto world = parse_wall_segments(text, "input"))
    for (const WallFace& wall : world->walls) walls_m += wall.floor_edge.length();
  return walls_m < kWallsMax_m;
}

/// What exploring asks of a world before it begins.
void look_around(const World& world) {
  if (!world.start) return;
  const FreeFloor floor(obstacles_below(world, 2), world.start->position(), 0.3);
  require(floor.area_m2() >= 0);
}

}  // namespace

/// A plan becomes a world with a tour, which is written, read again, and looked at as exploring does.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view text = fuzz_text(bytes, size);
  if (!is_read_by_aisle(text) || !is_small(text)) return 0;
  SilentProgress silent;
  Console console{silent, [](const std::string&) {}};
  ConvertOptions options;
  options.plan = fuzz_file(".plan", bytes, size);
  options.out = options.plan;
  options.out.replace_extension(".yaml");
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
