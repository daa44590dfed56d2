#pragma once
/// A building to drive in, in the frame `world`: metres, x right, y up, z from the floor; headings
/// counter-clockwise. Brightness is the share of light that a surface reflects, 0 black to 1 white.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/geometry/segment2.hpp"
#include "aisle/maps/room_route.hpp"
#include "aisle/simulation/calibration_board.hpp"

namespace aisle {

/// A thin piece of wall that stands on the floor, opaque from both sides. Where only one side is free, it is
/// on the left. A real wall has two faces and is two of these.
struct WallFace {
  Segment2 floor_edge;
  double height_m = 2.7;
  double brightness = 0.75;
  /// Share of a range scanner's beams that it sends back; the others go through. Less than 1: it is a pane of
  /// glass, which cameras do not see either.
  double returns = 1;

  bool is_glass() const { return returns < 1; }
};

/// A door leaf on its hinge, with the frame that it closes.
struct Door {
  Vec2 hinge = Vec2::Zero();      ///< on the floor, in the middle of the leaf's thickness
  double closed_heading_rad = 0;  ///< from the hinge to the lock when closed
  double open_rad = 0;            ///< turned about the hinge from closed, counter-clockwise
  double width_m = 0.9;
  double height_m = 2.05;
  double brightness = 0.45;
  double frame_width_m = 0.08;  ///< of the frame around the opening, seen from ahead; 0: none
  double frame_brightness = 0.25;
  /// Thickness of the wall whose gap it closes, half of it on either side of the closed leaf; the wall
  /// continues above. 0: it is mounted on a wall that continues behind it.
  double wall_depth_m = 0;
};

/// Something flat that hangs on a wall.
struct Poster {
  enum class Kind { kPoster, kNoticeBoard };
  Kind kind = Kind::kPoster;
  Vec2 centre = Vec2::Zero();  ///< on the wall
  double facing_rad = 0;       ///< direction of its outward normal
  double width_m = 0.6;
  double height_m = 0.85;
  double bottom_m = 1.2;  ///< above the floor
};

/// A lit rectangle on the ceiling that shines downwards.
struct Lamp {
  Vec2 centre = Vec2::Zero();
  double length_m = 1.2;
  double width_m = 0.3;
  double heading_rad = 0;  ///< of its length
  double power = 1;        ///< 1: an ordinary office lamp
};

struct FloorCovering {
  enum class Kind { kPlain, kTiles, kCarpet };
  Kind kind = Kind::kTiles;
  double tile_m = 0.3;  ///< side of a tile, or of the carpet's pattern
  double brightness = 0.5;
  double contrast = 0.1;  ///< of joints, stains and pattern against it
  double gloss = 0;       ///< 0: dull; 1: polished, a mirror at grazing angles
};

/// A sheet of paper that lies on the floor.
struct FloorPaper {
  Vec2 centre = Vec2::Zero();
  double heading_rad = 0;
  double length_m = 0.297;
  double width_m = 0.21;
  double brightness = 0.95;
};

struct Furniture {
  enum class Kind {
    kBox,     ///< closed from the floor up
    kTable,   ///< a top on four legs
    kChair,   ///< a seat on four legs, and a back at its rear
    kPillar,  ///< round; size.x is its diameter
  };
  Kind kind = Kind::kBox;
  Vec2 centre = Vec2::Zero();
  Vec2 size = Vec2::Ones();  ///< along x and y before it is turned
  double heading_rad = 0;
  double height_m = 0.75;
  double brightness = 0.5;
  double returns =
      1;  ///< share of a range scanner's beams that it sends back; black surfaces absorb the others
};

/// A rectangle painted on the floor to park in (L96 section 5).
struct ParkingFrame {
  std::string name;
  Vec2 centre = Vec2::Zero();
  Vec2 size = Vec2::Ones();  ///< outer measures along x and y before it is turned
  double heading_rad = 0;    ///< of a vehicle that stands in it
  double line_width_m = 0.05;
  double brightness = 0.95;
};

/// Walks to and fro along a path, for ever.
struct Person {
  std::vector<Vec2> path;  ///< at least two points
  double speed_mps = 1.0;
  double start_s = 0;  ///< waits at the path's first point until then
  double radius_m = 0.25;
  double height_m = 1.7;
};

/// A named pose that a vehicle may be sent to or may start from.
struct NamedPlace {
  std::string name;
  Pose2 T_world_place;
};

/// A route that a person shows the vehicle, and how to park at its end (L96).
struct WorldRoute {
  std::string name;
  ParkingStrategy parking = ParkingStrategy::kView;
  std::vector<Vec2> path;  ///< at least two different points; base_link drives from one to the next
};

/// A turning on a taught route (L96; docs/reference/turnings.md).
struct TaughtTurning {
  std::string route;       ///< WorldRoute::name
  int number = 1;          ///< 1 to 13
  Vec2 at = Vec2::Zero();  ///< the crossing's middle
  double before_m = 1.3;   ///< it begins this far before that point
  double after_m = 1.3;    ///< and ends this far beyond
};

/// How far skirting boards stand before their walls.
inline constexpr double kSkirtingDepth_m = 0.012;

struct World {
  std::string name;
  std::vector<WallFace> walls;
  std::vector<Door> doors;
  std::vector<Poster> posters;
  std::vector<Lamp> lamps;  ///< none: evenly lit
  std::vector<FloorPaper> papers;
  std::vector<Furniture> furniture;
  std::vector<ParkingFrame> parking_frames;
  std::vector<CalibrationBoard> boards;
  std::vector<Person> people;
  std::vector<NamedPlace> places;
  std::vector<WorldRoute> routes;
  std::vector<TaughtTurning> turnings;
  std::vector<Vec2> tour;      ///< waypoints that a vehicle drives to in this order; may be empty
  std::optional<Pose2> start;  ///< initial pose of a vehicle; else at the tour's start, facing along it

  FloorCovering floor;
  double ceiling_m = 2.7;
  double ceiling_brightness = 0.85;
  double skirting_height_m = 0.1;  ///< 0: none
  double skirting_brightness = 0.15;
  double ambient_light = 0.35;     ///< share of the light that comes from everywhere
  std::uint64_t texture_seed = 1;  ///< of stains, wood, print and carpet
};

}  // namespace aisle
