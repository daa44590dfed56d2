#include "world.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <string_view>

namespace robots {
namespace {

constexpr double kWallThickness_m = 0.02;
constexpr double kLeafThickness_m = 0.04;
constexpr double kLegThickness_m = 0.04;
constexpr double kPlateThickness_m = 0.03;
constexpr double kSeatHeight_m = 0.45;
constexpr double kPosterThickness_m = 0.004;
constexpr double kFrameRelief_m = 0.025;
constexpr double kSkirtingThickness_m = 0.006;

/// Keys of what no vehicle can run into, and of what start_of() and built() read themselves.
const std::set<std::string_view> kNotBuilt = {"format",
                                              "version",
                                              "name",
                                              "ceiling_m",
                                              "ceiling_brightness",
                                              "skirting_height_m",
                                              "skirting_brightness",
                                              "ambient_light",
                                              "lamps",
                                              "texture_seed",
                                              "floor",
                                              "papers",
                                              "parking_frames",
                                              "start",
                                              "tour",
                                              "places",
                                              "routes",
                                              "turnings"};

double number_or(const YAML::Node& node, const char* key, double otherwise) {
  return node[key] ? node[key].as<double>() : otherwise;
}

double heading_or_zero(const YAML::Node& node, const char* key) {
  return to_radians(number_or(node, key, 0));
}

Pose2 point(const YAML::Node& node) {
  return {node[0].as<double>(), node[1].as<double>(), 0};
}

Pose2 turned(Pose2 pose, double heading_rad) {
  pose.heading_rad = heading_rad;
  return pose;
}

/// Adds to the world what the entries of the file's lists stand for.
class Builder {
 public:
  Builder(World& world, const YAML::Node& file)
      : world_(world),
        ceiling_m_(number_or(file, "ceiling_m", 2.7)),
        skirting_m_(number_or(file, "skirting_height_m", 0.1)),
        skirting_brightness_(number_or(file, "skirting_brightness", 0.15)) {}

  void add_wall(const YAML::Node& entry) {
    const YAML::Node line = entry.IsMap() ? entry["line"] : entry;
    const double top_m = entry.IsMap() ? number_or(entry, "height_m", ceiling_m_) : ceiling_m_;
    const double brightness = entry.IsMap() ? number_or(entry, "brightness", 0.75) : 0.75;
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Pose2 from = point(line[i - 1]), to = point(line[i]);
      const double length_m = std::hypot(to.x - from.x, to.y - from.y);
      const Pose2 T_world_line = turned(from, std::atan2(to.y - from.y, to.x - from.x));
      // The line is the free side's face, and the free side is on its left.
      box(T_world_line * Pose2{length_m / 2, -kWallThickness_m / 2, 0}, length_m, kWallThickness_m, 0, top_m,
          brightness);
      if (skirting_m_ > 0)
        panel(T_world_line * Pose2{length_m / 2, 0, 0}, length_m, kSkirtingThickness_m, 0,
              std::min(skirting_m_, top_m), skirting_brightness_);
    }
  }

  void add_door(const YAML::Node& entry) {
    const double width_m = number_or(entry, "width_m", 0.9), height_m = number_or(entry, "height_m", 2.05);
    const double depth_m = number_or(entry, "wall_depth_m", 0);
    const Pose2 T_world_closed = turned(point(entry["hinge"]), heading_or_zero(entry, "closed_heading_deg"));
    const Pose2 T_world_leaf = T_world_closed * Pose2{0, 0, heading_or_zero(entry, "open_deg")};
    const Pose2 middle{width_m / 2, 0, 0};
    box(T_world_leaf * middle, width_m, kLeafThickness_m, 0, height_m, number_or(entry, "brightness", 0.45));
    if (depth_m > 0 && height_m < ceiling_m_) {
      box(T_world_closed * middle, width_m, depth_m, height_m, ceiling_m_, 0.75);
    }
    const double frame_m = number_or(entry, "frame_width_m", 0.08);
    if (frame_m <= 0) return;
    const double frame_brightness = number_or(entry, "frame_brightness", 0.25);
    for (const double x : {-frame_m / 2, width_m + frame_m / 2}) {
      panel(T_world_closed * Pose2{x, 0, 0}, frame_m, depth_m + 2 * kFrameRelief_m, 0, height_m + frame_m,
            frame_brightness);
    }
  }

  void add_poster(const YAML::Node& entry) {
    const bool is_board = entry["kind"] && entry["kind"].as<std::string>() == "notice_board";
    const double bottom_m = number_or(entry, "bottom_m", 1.2);
    const Pose2 T_world_poster = turned(point(entry["centre"]), heading_or_zero(entry, "facing_deg"));
    panel(T_world_poster, kPosterThickness_m, number_or(entry, "width_m", 0.6), bottom_m,
          bottom_m + number_or(entry, "height_m", 0.85), is_board ? 0.4 : 0.15);
  }

  void add_furniture(const YAML::Node& entry) {
    const std::string kind = entry["kind"] ? entry["kind"].as<std::string>() : "box";
    const Pose2 T_world_piece = turned(point(entry["centre"]), heading_or_zero(entry, "heading_deg"));
    const double length_m = entry["size"][0].as<double>(), width_m = entry["size"][1].as<double>();
    const double height_m = number_or(entry, "height_m", 0.75);
    const double brightness = number_or(entry, "brightness", 0.5);
    if (kind == "box") {
      box(T_world_piece, length_m, width_m, 0, height_m, brightness);
    } else if (kind == "pillar") {
      world_.solids.push_back(
          {Solid::Shape::kPillar, T_world_piece, length_m, length_m, 0, height_m, brightness});
    } else if (kind == "table") {
      plate_on_legs(T_world_piece, length_m, width_m, height_m, brightness);
    } else if (kind == "chair") {
      const double seat_m = std::min(kSeatHeight_m, height_m);
      plate_on_legs(T_world_piece, length_m, width_m, seat_m, brightness);
      box(T_world_piece * Pose2{-(length_m - kLegThickness_m) / 2, 0, 0}, kLegThickness_m, width_m, seat_m,
          height_m, brightness);
    } else {
      world_.left_out.push_back(kind);
    }
  }

 private:
  void box(const Pose2& T_world_centre, double length_m, double width_m, double bottom_m, double top_m,
           double brightness) {
    if (length_m <= 0 || width_m <= 0 || top_m <= bottom_m) return;
    world_.solids.push_back(
        {Solid::Shape::kBox, T_world_centre, length_m, width_m, bottom_m, top_m, brightness});
  }

  void panel(const Pose2& T_world_centre, double length_m, double width_m, double bottom_m, double top_m,
             double brightness) {
    world_.solids.push_back(
        {Solid::Shape::kBox, T_world_centre, length_m, width_m, bottom_m, top_m, brightness, false});
  }

  void plate_on_legs(const Pose2& T_world_plate, double length_m, double width_m, double top_m,
                     double brightness) {
    const double bottom_m = std::max(0.0, top_m - kPlateThickness_m);
    box(T_world_plate, length_m, width_m, bottom_m, top_m, brightness);
    const double x_m = (length_m - kLegThickness_m) / 2, y_m = (width_m - kLegThickness_m) / 2;
    for (const double x : {-x_m, x_m}) {
      for (const double y : {-y_m, y_m}) {
        box(T_world_plate * Pose2{x, y, 0}, kLegThickness_m, kLegThickness_m, 0, bottom_m, brightness);
      }
    }
  }

  World& world_;
  double ceiling_m_;
  double skirting_m_;
  double skirting_brightness_;
};

/// A world that names no start is entered at the tour's first point, along the tour.
Pose2 start_of(const YAML::Node& file) {
  if (file["start"]) {
    return turned(point(file["start"]["at"]), heading_or_zero(file["start"], "heading_deg"));
  }
  if (!file["tour"]) return {};
  const Pose2 from = point(file["tour"][0]), to = point(file["tour"][1]);
  return turned(from, std::atan2(to.y - from.y, to.x - from.x));
}

using AddEntry = void (Builder::*)(const YAML::Node&);

const std::map<std::string_view, AddEntry> kBuilt = {{"walls", &Builder::add_wall},
                                                     {"doors", &Builder::add_door},
                                                     {"posters", &Builder::add_poster},
                                                     {"furniture", &Builder::add_furniture},
                                                     {"boxes", &Builder::add_furniture}};

World built(const YAML::Node& file) {
  World world;
  world.T_world_start = start_of(file);
  for (const YAML::Node& place : file["tour"]) world.tour.push_back(point(place));
  world.tile_m = file["floor"] ? number_or(file["floor"], "tile_m", 0.3) : 0.3;
  world.floor_brightness = file["floor"] ? number_or(file["floor"], "brightness", 0.5) : 0.5;
  Builder builder(world, file);
  for (const auto& list : file) {
    const auto name = list.first.as<std::string>();
    if (const auto added = kBuilt.find(name); added != kBuilt.end()) {
      for (const YAML::Node& entry : list.second) (builder.*added->second)(entry);
    } else if (!kNotBuilt.contains(name)) {
      world.left_out.push_back(name);
    }
  }
  return world;
}

}  // namespace

World read_world(const std::string& path) {
  try {
    const YAML::Node file = YAML::LoadFile(path);
    if (!file["format"] || file["format"].as<std::string>() != "aisle.world") {
      throw std::runtime_error("not a file of the format aisle.world");
    }
    return built(file);
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace robots
