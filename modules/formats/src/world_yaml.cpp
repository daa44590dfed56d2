#include "aisle/formats/world_yaml.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

#include "aisle/core/angle.hpp"
#include "aisle/formats/whole_file.hpp"

namespace aisle {
namespace {

constexpr std::size_t kBytesMax = 16 << 20;
constexpr std::size_t kWallsMax = 200'000;
constexpr std::size_t kTourMax = 10'000;
constexpr std::size_t kProblemsMax = 50;
constexpr double kCoordinateMax_m = 10'000;

std::optional<double> parse_number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Reads one document; collects problems instead of stopping at the first.
class WorldReader {
 public:
  explicit WorldReader(std::string file) : file_(std::move(file)) {}

  Result<World> read(const std::string& text);

 private:
  using Reader = void (WorldReader::*)(const YAML::Node&);

  void read_document(const YAML::Node& document);
  void read_format(const YAML::Node& node);
  void read_version(const YAML::Node& node);
  void read_name(const YAML::Node& node);
  void read_walls(const YAML::Node& node);
  void read_boxes(const YAML::Node& node);
  void read_tour(const YAML::Node& node);
  void add_box(const YAML::Node& node, const std::string& key);
  void add_wall(const YAML::Node& node, const std::string& key, const Vec2& start, const Vec2& end);

  std::vector<Vec2> points(const YAML::Node& node, const std::string& key);
  std::optional<Vec2> point(const YAML::Node& node, const std::string& key);
  std::optional<double> number(const YAML::Node& node, const std::string& key, double limit);
  bool is_list(const YAML::Node& node, const std::string& key);
  bool is_room_left(const YAML::Node& node, const std::string& key, std::size_t count, std::size_t limit);
  void problem(const YAML::Node& node, const std::string& key, std::string what);
  bool has_given_up() const { return problems_.size() >= kProblemsMax; }

  std::string file_;
  World world_;
  Problems problems_;
};

Result<World> WorldReader::read(const std::string& text) {
  try {
    read_document(YAML::Load(text));
  } catch (const YAML::Exception& error) {
    return Problem{{file_, error.mark.line + 1}, "is not YAML: " + error.msg};
  }
  if (!problems_.empty()) return problems_;
  return world_;
}

void WorldReader::read_document(const YAML::Node& document) {
  static constexpr std::array<std::pair<const char*, Reader>, 6> kKeys = {
      {{"format", &WorldReader::read_format},
       {"version", &WorldReader::read_version},
       {"name", &WorldReader::read_name},
       {"walls", &WorldReader::read_walls},
       {"boxes", &WorldReader::read_boxes},
       {"tour", &WorldReader::read_tour}}};
  if (!document.IsMap()) {
    problem(document, "", "is not a world: expected keys, the first 'format: aisle.world'");
    return;
  }
  for (const auto& entry : document) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
    const auto known =
        std::find_if(kKeys.begin(), kKeys.end(), [&](const auto& k) { return key == k.first; });
    if (known == kKeys.end()) {
      problem(entry.first, key, "unknown key (known: format, version, name, walls, boxes, tour)");
    } else {
      (this->*known->second)(entry.second);
    }
  }
  for (const char* key : {"format", "version", "walls"}) {
    if (!document[key]) problem(document, key, "is missing");
  }
}

void WorldReader::read_format(const YAML::Node& node) {
  if (!node.IsScalar() || node.Scalar() != "aisle.world") problem(node, "format", "is not aisle.world");
}

void WorldReader::read_version(const YAML::Node& node) {
  if (!node.IsScalar() || node.Scalar() != "1") problem(node, "version", "is not 1, the only version so far");
}

void WorldReader::read_name(const YAML::Node& node) {
  if (node.IsScalar()) {
    world_.name = node.Scalar();
  } else {
    problem(node, "name", "is not a text");
  }
}

void WorldReader::read_walls(const YAML::Node& node) {
  if (!is_list(node, "walls")) return;
  for (std::size_t i = 0; i < node.size() && !has_given_up(); ++i) {
    const std::string key = fmt::format("walls[{}]", i);
    if (!is_list(node[i], key)) continue;
    if (!is_room_left(node[i], key, world_.walls.size() + node[i].size(), kWallsMax)) return;
    if (node[i].size() < 2) problem(node[i], key, "a wall needs at least two points");
    const std::vector<Vec2> corners = points(node[i], key);
    for (std::size_t j = 1; j < corners.size(); ++j) add_wall(node[i], key, corners[j - 1], corners[j]);
  }
}

void WorldReader::add_wall(const YAML::Node& node, const std::string& key, const Vec2& start,
                           const Vec2& end) {
  if (start == end) {
    problem(node, key,
            fmt::format("the point [{:g}, {:g}] stands there twice in succession", start.x(), start.y()));
  } else {
    world_.walls.push_back({start, end});
  }
}

void WorldReader::read_boxes(const YAML::Node& node) {
  if (!is_list(node, "boxes") || !is_room_left(node, "boxes", node.size(), kWallsMax / 4)) return;
  for (std::size_t i = 0; i < node.size() && !has_given_up(); ++i)
    add_box(node[i], fmt::format("boxes[{}]", i));
}

/// The walls of a box run clockwise: its outside, where one can drive, is on their left.
void WorldReader::add_box(const YAML::Node& node, const std::string& key) {
  if (!node.IsMap()) {
    problem(node, key, "is not a box such as {centre: [x, y], size: [x, y]}");
    return;
  }
  std::optional<Vec2> centre, size;
  double heading_deg = 0;
  for (const auto& entry : node) {
    const std::string name = entry.first.IsScalar() ? entry.first.Scalar() : "";
    const std::string inner = key + "." + name;
    if (name == "centre") {
      centre = point(entry.second, inner);
    } else if (name == "size") {
      size = point(entry.second, inner);
    } else if (name == "heading_deg") {
      heading_deg = number(entry.second, inner, 360).value_or(0);
    } else {
      problem(entry.first, inner, "unknown key (known: centre, size, heading_deg)");
    }
  }
  if (!node["centre"]) problem(node, key + ".centre", "is missing");
  if (!node["size"]) problem(node, key + ".size", "is missing");
  if (!centre || !size) return;
  if (size->minCoeff() <= 0) {
    problem(node, key + ".size", "is not positive");
    return;
  }
  const Pose2 T_world_box{centre->x(), centre->y(), heading_deg * kDegree};
  const double x = size->x() / 2, y = size->y() / 2;
  const std::array<Vec2, 4> corners = {Vec2(-x, -y), Vec2(-x, y), Vec2(x, y), Vec2(x, -y)};
  for (std::size_t i = 0; i < 4; ++i) {
    world_.walls.push_back(T_world_box * Segment2{corners[i], corners[(i + 1) % 4]});
  }
}

void WorldReader::read_tour(const YAML::Node& node) {
  if (!is_list(node, "tour") || !is_room_left(node, "tour", node.size(), kTourMax)) return;
  world_.tour = points(node, "tour");
  const bool leads_somewhere = std::any_of(world_.tour.begin(), world_.tour.end(),
                                           [&](const Vec2& p) { return p != world_.tour.front(); });
  if (node.size() > 0 && !leads_somewhere && problems_.empty()) {
    problem(node, "tour", "needs at least two different points");
  }
}

/// The points that could be read.
std::vector<Vec2> WorldReader::points(const YAML::Node& node, const std::string& key) {
  std::vector<Vec2> read;
  for (std::size_t i = 0; i < node.size() && !has_given_up(); ++i) {
    if (const auto p = point(node[i], fmt::format("{}[{}]", key, i))) read.push_back(*p);
  }
  return read;
}

std::optional<Vec2> WorldReader::point(const YAML::Node& node, const std::string& key) {
  if (!node.IsSequence() || node.size() != 2) {
    problem(node, key, "is not [x, y]");
    return std::nullopt;
  }
  const auto x = number(node[0], key, kCoordinateMax_m), y = number(node[1], key, kCoordinateMax_m);
  if (!x || !y) return std::nullopt;
  return Vec2(*x, *y);
}

std::optional<double> WorldReader::number(const YAML::Node& node, const std::string& key, double limit) {
  const std::string text = node.IsScalar() ? node.Scalar() : "this";
  const std::optional<double> value = node.IsScalar() ? parse_number(text) : std::nullopt;
  if (!value) {
    problem(node, key, fmt::format("{:.40} is not a number", text));
    return std::nullopt;
  }
  if (std::abs(*value) > limit) {
    problem(node, key, fmt::format("{:.40} is outside {:g} .. {:g}", text, -limit, limit));
    return std::nullopt;
  }
  return value;
}

bool WorldReader::is_list(const YAML::Node& node, const std::string& key) {
  if (!node.IsSequence()) problem(node, key, "is not a list");
  return node.IsSequence();
}

bool WorldReader::is_room_left(const YAML::Node& node, const std::string& key, std::size_t count,
                               std::size_t limit) {
  if (count > limit) problem(node, key, fmt::format("makes {} entries; at most {} are read", count, limit));
  return count <= limit;
}

void WorldReader::problem(const YAML::Node& node, const std::string& key, std::string what) {
  if (has_given_up()) return;
  problems_.push_back({{file_, std::max(0, node.Mark().line) + 1, key}, std::move(what)});
  if (has_given_up()) problems_.push_back({{file_}, "and more; only the first are listed"});
}

/// "x1 y1 x2 y2" and whatever follows.
std::optional<Segment2> parse_segment(std::string_view line) {
  std::array<double, 4> numbers{};
  for (double& value : numbers) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t\r"), line.size()));
    const std::size_t length = std::min(line.find_first_of(" \t\r"), line.size());
    const auto parsed = parse_number(line.substr(0, length));
    if (!parsed || std::abs(*parsed) > kCoordinateMax_m) return std::nullopt;
    value = *parsed;
    line.remove_prefix(length);
  }
  return Segment2{{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
}

std::string polyline_text(const std::vector<Vec2>& points, std::string_view indent) {
  constexpr std::size_t kPointsInALine = 6;
  std::string text = "[";
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) text += i % kPointsInALine == 0 ? fmt::format(",\n{}", indent) : ", ";
    text += fmt::format("[{:.6g}, {:.6g}]", std::round(points[i].x() * 1000) / 1000,
                        std::round(points[i].y() * 1000) / 1000);
  }
  return text + "]";
}

std::vector<std::vector<Vec2>> polylines(const std::vector<Segment2>& walls) {
  std::vector<std::vector<Vec2>> joined;
  for (const Segment2& wall : walls) {
    if (joined.empty() || joined.back().back() != wall.start) joined.push_back({wall.start});
    joined.back().push_back(wall.end);
  }
  return joined;
}

}  // namespace

Result<World> read_world(const std::filesystem::path& path) {
  const Result<std::string> text = read_whole_file(path, kBytesMax);
  if (!text) return text.problems();
  return WorldReader(path.string()).read(*text);
}

std::string world_yaml(const World& world) {
  YAML::Emitter name;
  name << YAML::DoubleQuoted << world.name;
  std::string text = fmt::format("format: aisle.world\nversion: 1\nname: {}\nwalls:{}\n", name.c_str(),
                                 world.walls.empty() ? " []" : "");
  for (const std::vector<Vec2>& line : polylines(world.walls)) {
    text += fmt::format("  - {}\n", polyline_text(line, "     "));
  }
  return text + fmt::format("tour: {}\n", polyline_text(world.tour, "  "));
}

Result<World> read_wall_segments(const std::filesystem::path& path) {
  const Result<std::string> text = read_whole_file(path, kBytesMax);
  if (!text) return text.problems();
  World world{.name = path.stem().string(), .walls = {}, .tour = {}};
  Problems problems;
  long line_number = 0;
  for (std::string_view rest = *text; !rest.empty() && problems.size() < kProblemsMax;) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    ++line_number;
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string_view::npos || line[first] == '#') continue;
    if (const auto segment = parse_segment(line)) {
      world.walls.push_back(*segment);
    } else {
      problems.push_back(
          {{path.string(), line_number}, "is not 'x1 y1 x2 y2 kind' in metres, at most 10 km from 0"});
    }
  }
  if (!problems.empty()) return problems;
  if (world.walls.empty()) return Problem{{path.string()}, "has no wall segments"};
  if (world.walls.size() > kWallsMax) return Problem{{path.string()}, "has more than 200000 wall segments"};
  return world;
}

}  // namespace aisle
