#include "aisle/formats/world_yaml.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "aisle/core/angle.hpp"
#include "aisle/formats/whole_file.hpp"
#include "field_reader.hpp"
#include "problem_list.hpp"

namespace aisle {
namespace {

constexpr std::size_t kBytesMax = 16 << 20;
constexpr std::size_t kWallsMax = 200'000;
constexpr std::size_t kTourMax = 10'000;
constexpr double kCoordinateMax_m = 10'000;

std::string text_of(const YAML::Node& node) {
  return node.IsScalar() ? node.Scalar() : std::string();
}

/// Reads one document; collects problems instead of stopping at the first.
class WorldReader {
 public:
  explicit WorldReader(const std::string& file) : file_(file), problems_(file) {}

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

  std::string file_;
  World world_;
  ProblemList problems_;
};

Result<World> WorldReader::read(const std::string& text) {
  try {
    read_document(YAML::Load(text));
  } catch (const YAML::Exception& error) {
    return Problem{{file_, error.mark.line + 1}, "is not YAML: " + error.msg};
  }
  if (!problems_.empty()) return problems_.take();
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
  std::set<std::string> seen;
  for (const auto& entry : document) {
    const std::string key = text_of(entry.first);
    if (!seen.insert(key).second) problem(entry.first, key, "stands there twice");
    const auto known =
        std::find_if(kKeys.begin(), kKeys.end(), [&](const auto& k) { return key == k.first; });
    if (known == kKeys.end()) {
      problem(entry.first, printable(key), "unknown key (known: format, version, name, walls, boxes, tour)");
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
  for (std::size_t i = 0; i < node.size(); ++i) {
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
    world_.walls.push_back({.foot = {start, end}});
  }
}

void WorldReader::read_boxes(const YAML::Node& node) {
  if (!is_list(node, "boxes") || !is_room_left(node, "boxes", node.size(), kWallsMax / 4)) return;
  for (std::size_t i = 0; i < node.size(); ++i) add_box(node[i], fmt::format("boxes[{}]", i));
}

void WorldReader::add_box(const YAML::Node& node, const std::string& key) {
  if (!node.IsMap()) {
    problem(node, key, "is not a box such as {centre: [x, y], size: [x, y]}");
    return;
  }
  Vec2 centre = Vec2::Zero(), size = Vec2::Ones();
  double heading_deg = 0;
  for (const auto& entry : node) {
    const std::string name = text_of(entry.first);
    const std::string inner = key + "." + printable(name);
    if (name == "centre") {
      centre = point(entry.second, inner).value_or(centre);
    } else if (name == "size") {
      size = point(entry.second, inner).value_or(size);
    } else if (name == "heading_deg") {
      heading_deg = number(entry.second, inner, 360).value_or(0);
    } else {
      problem(entry.first, inner, "unknown key (known: centre, size, heading_deg)");
    }
  }
  if (!node["centre"]) problem(node, key + ".centre", "is missing");
  if (!node["size"]) problem(node, key + ".size", "is missing");
  if (size.minCoeff() <= 0) problem(node, key + ".size", "is not positive");
  world_.furniture.push_back({.centre = centre, .size = size, .heading_rad = heading_deg * kDegree});
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
  for (std::size_t i = 0; i < node.size(); ++i) {
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
  const std::string text = node.IsScalar() ? node.Scalar() : "a list";
  const std::optional<double> value = parse_number(text);
  if (!value || !std::isfinite(*value)) {
    problem(node, key, fmt::format("'{}' is not a number", printable(text)));
    return std::nullopt;
  }
  if (std::abs(*value) > limit) {
    problem(node, key, fmt::format("{} is outside {:g} .. {:g}", printable(text), -limit, limit));
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
  problems_.add(std::max(0, node.Mark().line) + 1, key, std::move(what));
}

}  // namespace

Result<World> read_world(const std::filesystem::path& path) {
  const Result<std::string> text = read_whole_file(path, kBytesMax);
  if (!text) return text.problems();
  return parse_world(*text, path.string());
}

Result<World> parse_world(const std::string& text, const std::string& name) {
  return WorldReader(name).read(text);
}

}  // namespace aisle
