#include "model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace robots {
namespace {

struct Bounds {
  double left = std::numeric_limits<double>::max(), right = std::numeric_limits<double>::lowest();
  double bottom = left, top = right;

  void include(const Pose2& p_world, double margin_m) {
    left = std::min(left, p_world.x - margin_m);
    right = std::max(right, p_world.x + margin_m);
    bottom = std::min(bottom, p_world.y - margin_m);
    top = std::max(top, p_world.y + margin_m);
  }
};

Bounds bounds_of(const World& world, const Pose2& T_world_start) {
  Bounds bounds;
  bounds.include(T_world_start, 1);
  for (const Solid& solid : world.solids) {
    for (const double x : {-solid.length_m / 2, solid.length_m / 2}) {
      bounds.include(solid.T_world_centre * Pose2{x, 0, 0}, 0.2);
    }
  }
  return bounds;
}

std::string geom_of(const Solid& solid) {
  const bool is_box = solid.shape == Solid::Shape::kBox;
  const double half_height_m = (solid.top_m - solid.bottom_m) / 2;
  const std::string size = is_box
                               ? fmt::format("{} {} {}", solid.length_m / 2, solid.width_m / 2, half_height_m)
                               : fmt::format("{} {}", solid.length_m / 2, half_height_m);
  return fmt::format(R"(
  <geom class="{0}" type="{1}" pos="{2} {3} {4}" euler="0 0 {5}" size="{6}" rgba="{7} {7} {7} 1"/>)",
                     solid.is_obstacle ? "obstacle" : "panel", is_box ? "box" : "cylinder",
                     solid.T_world_centre.x, solid.T_world_centre.y, solid.bottom_m + half_height_m,
                     solid.T_world_centre.heading_rad, size, solid.brightness);
}

/// So far away, and with so narrow a view, that walls are seen from above alone.
std::string camera_above(const Bounds& bounds) {
  constexpr double kFovy_deg = 4;
  const double seen_m = std::max(bounds.top - bounds.bottom, 0.75 * (bounds.right - bounds.left));
  const double distance_m = seen_m / 2 / std::tan(to_radians(kFovy_deg) / 2);
  return fmt::format("\n  <camera name=\"top\" pos=\"{} {} {}\" fovy=\"{}\"/>",
                     (bounds.left + bounds.right) / 2, (bounds.bottom + bounds.top) / 2, distance_m,
                     kFovy_deg);
}

std::string floor_geom(const Bounds& bounds) {
  return fmt::format("\n  <geom class=\"floor\" pos=\"{} {} 0\" size=\"{} {} 1\" material=\"floor\"/>",
                     (bounds.left + bounds.right) / 2, (bounds.bottom + bounds.top) / 2,
                     (bounds.right - bounds.left) / 2 + 5, (bounds.top - bounds.bottom) / 2 + 5);
}

/// The checkered texture has two tiles a side, and MuJoCo lays it from -1 to 1.
std::string floor_material(const World& world) {
  constexpr double kContrast = 0.08;
  const double dark = std::max(0.0, world.floor_brightness - kContrast / 2);
  const double light = std::min(1.0, dark + kContrast);
  return fmt::format(R"(
  <texture name="floor" type="2d" builtin="checker" width="128" height="128" rgb1="{0} {0} {0}" rgb2="{1} {1} {1}"/>
  <material name="floor" texture="floor" texuniform="true" texrepeat="{2} {2}"/>)",
                     light, dark, 1 / world.tile_m);
}

/// Wheels and casters meet the floor alone (bit 1), the hull meets what stands on it (bit 2).
std::string classes(const Vehicle& vehicle, double wheel_friction) {
  return fmt::format(R"(
  <default class="floor"><geom type="plane" group="{0}" contype="1" conaffinity="1"/></default>
  <default class="obstacle"><geom group="{0}" contype="2" conaffinity="2"/></default>
  <default class="panel"><geom group="{1}" contype="0" conaffinity="0"/></default>
  <default class="hull"><geom type="box" group="{2}" contype="2" conaffinity="2" friction="0.5 0.005 0.0001" priority="1" rgba="0.2 0.3 0.7 1"/></default>
  <default class="inside"><geom type="box" group="3" contype="0" conaffinity="0"/></default>
  <default class="caster"><geom type="sphere" group="{2}" contype="0" conaffinity="1" condim="1" mass="0.05" priority="1"/></default>
  <default class="wheel"><geom type="cylinder" group="{2}" contype="0" conaffinity="1" size="{3} 0.01" euler="1.5708 0 0"
    mass="0.3" friction="{4} 0.005 0.0001" priority="1" rgba="0.1 0.1 0.1 1"/></default>)",
                     kObstacleGroup, kPanelGroup, kVehicleGroup, vehicle.wheel_radius_m, wheel_friction);
}

}  // namespace

std::string model_of(const World& world, const Vehicle& vehicle, const Pose2& T_world_start,
                     const ModelSettings& settings) {
  const Bounds bounds = bounds_of(world, T_world_start);
  std::string solids;
  for (const Solid& solid : world.solids) solids += geom_of(solid);
  const std::string pose = fmt::format("pos=\"{} {} 0\" euler=\"0 0 {}\"", T_world_start.x, T_world_start.y,
                                       T_world_start.heading_rad);
  return fmt::format(R"(<mujoco>
<compiler angle="radian"/>
<option timestep="{}" cone="elliptic" impratio="10"/>
<visual>
  <global offwidth="{}" offheight="{}"/><map znear="0.005" zfar="200"/><quality shadowsize="0"/>
  <headlight ambient="0.5 0.5 0.5" diffuse="0.3 0.3 0.3" specular="0 0 0"/>
</visual>
<statistic extent="10"/>
<default>{}
</default>
<asset>{}
</asset>
<worldbody>
  <light directional="true" dir="0.3 0.5 -1" diffuse="0.4 0.4 0.4" specular="0 0 0" castshadow="false"/>)",
                     kStep_s, settings.image_width_px, settings.image_height_px,
                     classes(vehicle, settings.wheel_friction), floor_material(world)) +
         floor_geom(bounds) + camera_above(bounds) + solids + vehicle_body(vehicle, pose) +
         "\n</worldbody>\n<actuator>" + vehicle_actuators(vehicle) + "\n</actuator>\n</mujoco>\n";
}

}  // namespace robots
