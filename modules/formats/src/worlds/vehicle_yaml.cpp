#include "aisle/formats/worlds/vehicle_yaml.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <deque>
#include <string_view>

#include "aisle/formats/parameter_file.hpp"
#include "aisle/formats/whole_file.hpp"
#include "field_reader.hpp"
#include "file_limits.hpp"
#include "other_lens.hpp"
#include "parameter_tree.hpp"
#include "problem_list.hpp"
#include "yaml_text.hpp"

namespace aisle {
namespace {

constexpr std::size_t kCamerasMax = 16;
constexpr std::size_t kNameMax = 64;

using OtherLenses = std::deque<OtherLens>;

/// @param lenses  takes those that the fields need
/// @param of_all  of cameras with usual lenses, too: a file may say that they have others
FieldList described_fields(VehicleDescription& vehicle, OtherLenses& lenses, bool of_all = false) {
  FieldList fields = fields_of(vehicle);
  for (CameraDescription& camera : vehicle.cameras) {
    fields.group("cameras." + camera.name, camera);
    if (of_all || OtherLens::is_needed(camera.intrinsics))
      fields.group("cameras." + camera.name, lenses.emplace_back(camera.intrinsics));
  }
  if (vehicle.scanner) fields.group("scanner", *vehicle.scanner);
  if (vehicle.laser_markers) fields.group("laser_markers", *vehicle.laser_markers);
  return fields;
}

/// All fields of the file. The model must already have all its parts.
FieldList all_fields(VehicleModel& vehicle, OtherLenses& lenses, bool of_all = false) {
  FieldList fields = described_fields(vehicle.description, lenses, of_all);
  fields.group("simulated.odometry", vehicle.simulated.odometry);
  for (const CameraDescription& camera : vehicle.description.cameras) {
    fields.group("simulated.cameras." + camera.name, vehicle.simulated.cameras[camera.name]);
  }
  if (vehicle.description.scanner) fields.group("simulated.scanner", vehicle.simulated.scanner);
  return fields;
}

/// Reads one document: first which parts the vehicle has, then their fields.
class VehicleReader {
 public:
  explicit VehicleReader(const std::string& file) : file_(file), problems_(file) {}

  Result<VehicleModel> read(const YAML::Node& document) {
    if (!document.IsMap()) return Problem{{file_, 1}, "is not a vehicle: expected 'format: aisle.vehicle'"};
    read_header(document);
    if (const YAML::Node cameras = document["cameras"]) read_camera_names(cameras);
    if (document["scanner"]) vehicle_.description.scanner = kOneReadingADegree;
    if (document["laser_markers"]) vehicle_.description.laser_markers.emplace();
    read_fields(document);
    if (!problems_.empty()) return problems_.take();
    return vehicle_;
  }

 private:
  void problem(const YAML::Node& node, const std::string& key, std::string what) {
    problems_.add(std::max(0, node.Mark().line) + 1, key, std::move(what));
  }

  void read_header(const YAML::Node& document) {
    require(document, "format", "aisle.vehicle");
    require(document, "version", "1");
    const YAML::Node name = document["name"];
    if (!name) return;
    if (name.IsScalar() && name.Scalar().size() <= kNameMax && is_line_of_text(name.Scalar())) {
      vehicle_.description.name = name.Scalar();
    } else {
      problem(name, "name", fmt::format("is not a line of UTF-8 text of at most {} bytes", kNameMax));
    }
  }

  void require(const YAML::Node& document, const char* key, std::string_view value) {
    const YAML::Node node = document[key];
    if (!node) return problem(document, key, "is missing");
    if (!node.IsScalar() || node.Scalar() != value) problem(node, key, fmt::format("is not {}", value));
  }

  void read_camera_names(const YAML::Node& cameras) {
    if (!cameras.IsMap()) return;  // reported when the fields are read
    if (cameras.size() > kCamerasMax) {
      return problem(cameras, "cameras", fmt::format("are more than {}", kCamerasMax));
    }
    for (const auto& entry : cameras) {
      const std::string name = entry.first.IsScalar() ? entry.first.Scalar() : "";
      const std::string key = "cameras." + printable(name);
      if (!is_topic_word(name)) {
        problem(entry.first, key, "is not a camera name: a letter, then letters, digits and _");
      } else if (!is_new(name)) {
        problem(entry.first, key, "is given twice");
      } else {
        vehicle_.description.cameras.push_back({.name = name});
      }
    }
  }

  bool is_new(const std::string& camera) const {
    const auto& cameras = vehicle_.description.cameras;
    return std::none_of(cameras.begin(), cameras.end(), [&](const auto& c) { return c.name == camera; });
  }

  void read_fields(const YAML::Node& document) {
    OtherLenses lenses;
    FieldList fields = all_fields(vehicle_, lenses, true);
    ParameterTree tree(file_, fields);
    for (const auto& entry : document) {
      const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
      if (key != "format" && key != "version" && key != "name") tree.read(key, entry.second);
    }
    for (Problem& found : tree.take_problems()) problems_.add(std::move(found));
    for (OtherLens& lens : lenses) lens.settle_model();
  }

  std::string file_;
  VehicleModel vehicle_;
  ProblemList problems_;
};

std::string text_of(const std::string& name, const FieldList& fields) {
  return fmt::format("format: aisle.vehicle\nversion: 1\nname: {}\n{}", yaml_quoted(name),
                     parameters_yaml(fields));
}

}  // namespace

Result<VehicleModel> read_vehicle(const std::filesystem::path& path) {
  const Result<std::string> text = read_whole_file(path, kSettingsBytesMax);
  if (!text) return text.problems();
  return parse_vehicle(*text, path.string());
}

Result<VehicleModel> parse_vehicle(const std::string& text, const std::string& name) {
  try {
    return VehicleReader(name).read(load_yaml(text));
  } catch (const YAML::Exception& error) {
    return Problem{{name, error.mark.line + 1}, "is not YAML: " + error.msg};
  }
}

std::string vehicle_yaml(const VehicleDescription& vehicle) {
  VehicleDescription copy = vehicle;
  OtherLenses lenses;
  return text_of(vehicle.name, described_fields(copy, lenses));
}

std::string vehicle_yaml(const VehicleModel& vehicle) {
  VehicleModel copy = vehicle;
  OtherLenses lenses;
  return text_of(vehicle.description.name, all_fields(copy, lenses));
}

}  // namespace aisle
