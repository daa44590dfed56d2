#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>

#include "aisle/core/parameters.hpp"
#include "aisle/formats/images/map_server.hpp"
#include "aisle/formats/whole_file.hpp"
#include "field_reader.hpp"
#include "file_limits.hpp"
#include "problem_list.hpp"

namespace aisle {
namespace {

constexpr std::size_t kYamlBytesMax = 1 << 20;

/// Reads one YAML file; collects all problems instead of stopping at the first.
class MapYamlReader {
 public:
  explicit MapYamlReader(const std::string& file) : file_(file), problems_(file) {}

  Result<MapServerYaml> read(const std::string& text) {
    try {
      read_document(YAML::Load(text));
    } catch (const YAML::Exception& error) {
      return Problem{{file_, error.mark.line + 1}, "is not YAML: " + error.msg};
    }
    if (!problems_.empty()) return problems_.take();
    return map_;
  }

 private:
  void read_document(const YAML::Node& document) {
    if (!document.IsMap())
      return problems_.add(1, "is not a map: expected the keys image, resolution and origin");
    for (const char* key : {"image", "resolution", "origin"}) {
      if (!document[key]) problems_.add(1, key, "is missing");
    }
    if (const auto image = document["image"]) read_image(image);
    if (const auto resolution = document["resolution"]) {
      map_.resolution_m = number(resolution, "resolution", {0.001, 10}).value_or(map_.resolution_m);
    }
    if (const auto origin = document["origin"]) read_origin(origin);
    if (const auto negate = document["negate"]) read_negate(negate);
    if (const auto free = document["free_thresh"]) {
      map_.thresholds.free_below = number(free, "free_thresh", {0, 1}).value_or(0);
    }
  }

  void read_image(const YAML::Node& node) {
    if (node.IsScalar() && !node.Scalar().empty()) {
      map_.image = node.Scalar();
    } else {
      problem(node, "image", "is not the name of an image");
    }
  }

  void read_origin(const YAML::Node& node) {
    if (!node.IsSequence() || node.size() != 3) return problem(node, "origin", "is not [x, y, rotation]");
    const Range metres{-kCoordinateMax_m, kCoordinateMax_m}, radians{-7, 7};
    const auto x = number(node[0], "origin[0]", metres), y = number(node[1], "origin[1]", metres);
    const auto rotation = number(node[2], "origin[2]", radians);
    if (x && y && rotation) map_.T_map_plan = {*x, *y, *rotation};
  }

  void read_negate(const YAML::Node& node) {
    const std::string text = node.IsScalar() ? node.Scalar() : "a list";
    map_.thresholds.negate = text == "1" || text == "true";
    if (text != "0" && text != "1" && text != "true" && text != "false") {
      problem(node, "negate", fmt::format("'{}' is not 0 or 1", printable(text)));
    }
  }

  std::optional<double> number(const YAML::Node& node, const std::string& key, Range range) {
    const std::string text = node.IsScalar() ? node.Scalar() : "a list";
    const std::optional<double> value = parse_number(text);
    if (value && *value >= range.min && *value <= range.max) return value;
    problem(node, key,
            fmt::format("'{}' is not a number from {:g} to {:g}", printable(text), range.min, range.max));
    return std::nullopt;
  }

  void problem(const YAML::Node& node, const std::string& key, std::string what) {
    problems_.add(std::max(0, node.Mark().line) + 1, key, std::move(what));
  }

  std::string file_;
  MapServerYaml map_;
  ProblemList problems_;
};

}  // namespace

Result<MapServerYaml> parse_map_server_yaml(const std::string& text, const std::string& name) {
  return MapYamlReader(name).read(text);
}

Result<FloorPlan> read_map_server(const std::filesystem::path& yaml) {
  const Result<std::string> text = read_whole_file(yaml, kYamlBytesMax);
  if (!text) return text.problems();
  const auto map = parse_map_server_yaml(*text, yaml.string());
  if (!map) return map.problems();
  const std::filesystem::path image = yaml.parent_path() / map->image;
  const Result<std::string> bytes = read_whole_file(image, kPlanBytesMax);
  if (!bytes) return bytes.problems();
  Result<FloorPlan> plan = parse_plan_image(*bytes, image.string(), map->resolution_m, map->thresholds);
  if (plan) plan->T_world_plan = map->T_map_plan;
  return plan;
}

}  // namespace aisle
