#include "aisle/formats/worlds/world_yaml.hpp"

#include <fmt/format.h>

#include <utility>

#include "aisle/formats/whole_file.hpp"
#include "file_limits.hpp"
#include "object_reader.hpp"
#include "worlds/world_checks.hpp"
#include "worlds/world_fields.hpp"
#include "yaml_text.hpp"

namespace aisle {
namespace {

/// Reads one document.
class WorldReader {
 public:
  explicit WorldReader(const std::string& file) : file_(file), nodes_(file) {}

  Result<World> read(const std::string& text);

 private:
  void read_document(const YAML::Node& document);
  std::vector<ObjectReader::Section> sections();
  void read_walls(const YAML::Node& node, const std::string& key);
  void read_wall(const YAML::Node& node, const std::string& key);
  void add_faces(const YAML::Node& node, const std::string& key, const WallLine& wall);
  template <class Object>
  void read_list(const YAML::Node& node, const std::string& key, std::vector<Object>& objects,
                 std::size_t most);

  std::string file_;
  World world_;
  ObjectReader nodes_;
};

Result<World> WorldReader::read(const std::string& text) {
  try {
    read_document(load_yaml(text));
  } catch (const YAML::Exception& error) {
    return Problem{{file_, error.mark.line + 1}, "is not YAML: " + error.msg};
  }
  if (nodes_.problem_count() == 0) {
    for (const Problem& problem : contradictions(world_)) nodes_.problem(problem.where.key, problem.what);
  }
  if (nodes_.problem_count() > 0) return nodes_.take_problems();
  return std::move(world_);
}

void WorldReader::read_document(const YAML::Node& document) {
  if (!document.IsMap()) {
    return nodes_.problem(document, "", "is not a world: expected keys, the first 'format: aisle.world'");
  }
  nodes_.read_map(document, "", fields_of(world_), sections());
  for (WallFace& wall : world_.walls) {
    if (wall.height_m == WallLine{}.height_m) wall.height_m = world_.ceiling_m;
  }
}

std::vector<ObjectReader::Section> WorldReader::sections() {
  using Node = YAML::Node;
  using Key = std::string;
  std::vector<ObjectReader::Section> sections = {
      nodes_.constant("format", "aisle.world"),
      nodes_.constant("version", "1"),
      {"walls", [this](const Node& node, const Key& key) { read_walls(node, key); }, true},
      // the former name of furniture
      {"boxes",
       [this](const Node& node, const Key& key) { read_list(node, key, world_.furniture, kObjectsMax); }},
      {"floor",
       [this](const Node& node, const Key& key) { nodes_.read_map(node, key, fields_of(world_.floor)); }},
      {"start", [this](const Node& node, const Key& key) {
         nodes_.read_map(node, key, fields_of(world_.start.emplace()));
       }}};
  for_each_list(world_, [&](const char* name, auto& objects, std::size_t most) {
    sections.push_back({name, [this, &objects, most](const Node& node, const Key& key) {
                          read_list(node, key, objects, most);
                        }});
  });
  return sections;
}

void WorldReader::read_walls(const YAML::Node& node, const std::string& key) {
  if (!nodes_.is_list(node, key)) return;
  for (std::size_t i = 0; i < node.size() && !nodes_.is_hopeless(); ++i) {
    read_wall(node[i], fmt::format("{}[{}]", key, i));
  }
}

/// A wall with default values is written as its line alone.
void WorldReader::read_wall(const YAML::Node& node, const std::string& key) {
  const std::size_t problems_before = nodes_.problem_count();
  WallLine wall;
  if (node.IsSequence()) {
    nodes_.read_points(node, key, fields_of(wall).front().range, wall.line);
  } else {
    nodes_.read_map(node, key, fields_of(wall));
  }
  if (wall.line.size() < 2 && nodes_.problem_count() == problems_before) {
    nodes_.problem(node, key, "a wall needs at least two points");
  }
  if (nodes_.is_room_left(node, key, world_.walls.size() + wall.line.size(), kWorldWallsMax)) {
    add_faces(node, key, wall);
  }
}

void WorldReader::add_faces(const YAML::Node& node, const std::string& key, const WallLine& wall) {
  for (std::size_t i = 1; i < wall.line.size(); ++i) {
    const Vec2 &start = wall.line[i - 1], &end = wall.line[i];
    if (start == end) {
      nodes_.problem(node, key,
                     fmt::format("the point [{:g}, {:g}] is given twice in a row", end.x(), end.y()));
    }
    world_.walls.push_back({{start, end}, wall.height_m, wall.brightness, wall.returns});
  }
}

template <class Object>
void WorldReader::read_list(const YAML::Node& node, const std::string& key, std::vector<Object>& objects,
                            std::size_t most) {
  if (!nodes_.is_list(node, key) || !nodes_.is_room_left(node, key, objects.size() + node.size(), most))
    return;
  for (std::size_t i = 0; i < node.size() && !nodes_.is_hopeless(); ++i) {
    nodes_.read_map(node[i], fmt::format("{}[{}]", key, i), fields_of(objects.emplace_back()));
  }
}

}  // namespace

Result<World> read_world(const std::filesystem::path& path) {
  const Result<std::string> text = read_whole_file(path, kWorldBytesMax);
  if (!text) return text.problems();
  return parse_world(*text, path.string());
}

Result<World> parse_world(const std::string& text, const std::string& name) {
  return WorldReader(name).read(text);
}

}  // namespace aisle
