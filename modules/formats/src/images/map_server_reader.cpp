#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "aisle/core/parameters.hpp"
#include "aisle/formats/images/map_server.hpp"
#include "aisle/formats/whole_file.hpp"
#include "field_reader.hpp"
#include "file_limits.hpp"
#include "problem_list.hpp"
#include "yaml_text.hpp"

namespace aisle {
namespace {

constexpr std::size_t kYamlBytesMax = 1 << 20;

/// Reads one YAML file; collects all problems instead of stopping at the first.
class MapYamlReader {
 public:
  explicit MapYamlReader(const std::string& file) : file_(file), problems_(file) {}

  Result<MapServerYaml> read(const std::string& text) {
    try {
      read_document(load_yaml(text));
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
    add_duplicate_keys(document, problems_);
    for (const char* key : {"image", "resolution", "origin"}) {
      if (!document[key]) problems_.add(1, key, "is missing");
    }
    if (const auto image = document["image"]) read_image(image);
    if (const auto resolution = document["resolution"]) {
      map_.resolution_m = number(resolution, "resolution", {0.001, 10}).value_or(map_.resolution_m);
    }
    if (const auto origin = document["origin"]) read_origin(origin);
    if (const auto negate = document["negate"]) read_negate(negate);
    if (const auto mode = document["mode"]) read_mode(mode);
    read_thresholds(document["occupied_thresh"], document["free_thresh"]);
  }

  void read_thresholds(const YAML::Node& occupied, const YAML::Node& free) {
    if (occupied)
      map_.occupied_above = number(occupied, "occupied_thresh", {0, 1}).value_or(map_.occupied_above);
    if (free) map_.free_below = number(free, "free_thresh", {0, 1}).value_or(map_.free_below);
    map_.free_below_at = {file_, free ? line_of(free) : 1, "free_thresh"};
    if (map_.free_below < map_.occupied_above || map_.mode == MapMode::kRaw || !(free || occupied)) return;
    const std::string what =
        fmt::format("{:g} is not below occupied_thresh, {:g}", map_.free_below, map_.occupied_above);
    const Place where = free ? map_.free_below_at : Place{file_, line_of(occupied), "occupied_thresh"};
    if (map_.free_below > map_.occupied_above) {
      problems_.add(where.line, where.key,
                    free ? what + "; are they swapped?" : "is below free_thresh, 0.196");
    } else {
      map_.warnings.push_back({where, what + ": no grey is unknown"});
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
    const auto rotation =
        is_not_a_number(node[2]) ? no_rotation(node[2]) : number(node[2], "origin[2]", radians);
    if (x && y && rotation) map_.T_map_plan = {*x, *y, *rotation};
  }

  static bool is_not_a_number(const YAML::Node& node) {
    std::string text = node.IsScalar() ? node.Scalar() : "";
    if (text.starts_with('-') || text.starts_with('+')) text.erase(0, 1);
    if (text.starts_with('.')) text.erase(0, 1);
    return text == "nan" || text == "NaN" || text == "NAN";
  }

  std::optional<double> no_rotation(const YAML::Node& node) {
    map_.warnings.push_back({{file_, line_of(node), "origin[2]"},
                             fmt::format("'{}' is not a number; 0 is taken", node.Scalar())});
    return 0;
  }

  void read_negate(const YAML::Node& node) {
    const std::string text = node.IsScalar() ? node.Scalar() : "a list";
    if (text == "0" || text == "1") {
      map_.negate = text == "1";
    } else if (!YAML::convert<bool>::decode(node, map_.negate)) {
      problem(node, "negate", fmt::format("'{}' is not 0, 1, true or false", printable(text)));
    }
  }

  void read_mode(const YAML::Node& node) {
    const std::string text = node.IsScalar() ? node.Scalar() : "a list";
    static constexpr std::array kModes{MapMode::kTrinary, MapMode::kScale, MapMode::kRaw};
    const auto* mode =
        std::find_if(kModes.begin(), kModes.end(), [&](MapMode known) { return text == name_of(known); });
    if (mode == kModes.end())
      return problem(node, "mode", fmt::format("'{}' is not trinary, scale or raw", printable(text)));
    map_.mode = *mode;
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
    problems_.add(line_of(node), key, std::move(what));
  }

  static long line_of(const YAML::Node& node) { return std::max(0, node.Mark().line) + 1; }

  std::string file_;
  MapServerYaml map_;
  ProblemList problems_;
};

/// nav2's rule: "~/" is the home folder, and what is not absolute lies beside the YAML file.
Result<std::filesystem::path> image_path(const std::filesystem::path& yaml, const std::string& image) {
  if (!image.starts_with("~/")) return yaml.parent_path() / image;
  const char* home = std::getenv("HOME");  // NOLINT(concurrency-mt-unsafe): nobody changes it
  if (home == nullptr || *home == 0)
    return Problem{{yaml.string(), 0, "image"}, "is in the home folder (~), but HOME is not set"};
  return std::filesystem::path(home) / image.substr(2);
}

}  // namespace

Result<MapServerYaml> parse_map_server_yaml(const std::string& text, const std::string& name) {
  return MapYamlReader(name).read(text);
}

Result<PlanReading> read_map_server(const std::filesystem::path& yaml) {
  const Result<std::string> text = read_whole_file(yaml, kYamlBytesMax);
  if (!text) return text.problems();
  const auto map = parse_map_server_yaml(*text, yaml.string());
  if (!map) return map.problems();
  const auto image = image_path(yaml, map->image);
  if (!image) return image.problems();
  const Result<std::string> bytes = read_whole_file(*image, kPlanBytesMax);
  if (!bytes) return bytes.problems();
  const auto pixels = parse_plan_pixels(*bytes, image->string());
  if (!pixels) return pixels.problems();
  return plan_of_map(*pixels, *map);
}

}  // namespace aisle
