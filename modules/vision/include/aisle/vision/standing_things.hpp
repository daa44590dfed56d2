#pragma once
/// What stands on the floor ahead, where it meets the floor, and how far the floor is free.

#include <cstdint>
#include <optional>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/back_projection.hpp"
#include "aisle/geometry/camera_model.hpp"

namespace aisle {

/// The floor is looked at along rays over it, from below the camera outwards.
struct StandingThingParams {
  double reach_m = 8;         ///< how far from the camera the floor is looked at
  double foot_max_m = 5.5;    ///< things that stand farther from the camera are left for later
  double height_min_m = 0.3;  ///< of a thing; what covers less of the floor behind it may lie on it
  double strip_height_m = 0.05;
  double strip_width_m = 0.6;
  double tolerance = 5;  ///< [grey levels]
  double tolerance_share = 0.04;
  double texture_max = 25;
  double tint_tolerance = 24;
  double drift_per_m = 14;
  double foot_step = 8;

  void describe(FieldList& fields);
};

/// Something that is not floor.
struct StandingThing {
  Vec2 p_vehicle =
      Vec2::Zero();          ///< where it meets the floor; if `foot_hidden`, where its ray enters the picture
  double height_m = 0;       ///< at least so high if it stands there
  bool foot_hidden = false;  ///< it begins below the picture: it stands there or nearer
};

/// Finds what stands on the floor in single pictures of a camera whose lens and mount are known. Floor is
/// what looks like the floor before it; its brightness may drift along a ray. Where a ray leaves the floor,
/// and floor begins again only so far behind that a thing of the least height would hide as much, something
/// stands. What hides less (papers, tile joints, stains) lies on the floor, unless it crosses the view in a
/// strip: that is the skirting of a wall that looks like the floor. No allocation once warm.
class StandingThingDetector {
 public:
  /// @throws std::invalid_argument if the camera sees no floor within reach
  StandingThingDetector(const StandingThingParams& params, const CameraIntrinsics& intrinsics,
                        const CameraMount& mount, int width_px, int height_px);

  /// Things by ray from right to left; valid until the next call.
  /// A colour picture is looked at in colour.
  /// @throws std::invalid_argument unless the picture is of the camera's size, with 1 or 3 channels
  const std::vector<StandingThing>& detect(const Image& picture);

  enum class Seen {
    kFree,     ///< the floor is seen there
    kNothing,  ///< nothing is known: out of view, or hidden
    kTooNear,  ///< below the picture, and the floor is seen where the picture begins
  };
  /// What the last picture says of a place.
  Seen seen_at(const Vec2& p_vehicle) const;

  double mean_level() const { return mean_level_; }  ///< of the last picture [grey levels]

 private:
  /// Of a square of the picture. A grey picture has no tint.
  struct Look {
    std::uint8_t level = 0;
    std::int16_t red_green = 0, yellow_blue = 0;
  };
  struct Sample {
    std::uint32_t cell = 0;  ///< of the shrunk picture
    float away_m = 0;        ///< from below the camera
  };
  struct Ray {
    Vec2 direction = Vec2::UnitX();  ///< over the floor, in the vehicle's frame
    std::size_t first = 0, end = 0;  ///< its samples, outwards
  };
  /// What a ray leaves the floor at; samples by their index.
  struct Gap {
    bool is_thing = false;
    bool has_strip = false;  ///< before that: something that may be the skirting of a wall
    std::size_t thing = 0, strip = 0;
    double height_m = 0;      ///< of the thing
    double free_m = 0;        ///< how far from below the camera the floor is seen free
    double strip_free_m = 0;  ///< the same if the strip is a wall
  };

  void lay_rays(const CameraModel& camera, int width_px, int height_px);
  void shrink(const Image& picture);
  void follow_light(double mean_before);
  void learn_floor();
  Gap gap_of(const Ray& ray) const;
  std::size_t floor_again(const Ray& ray, std::size_t from, double level) const;
  std::size_t foot_of(const Gap& gap) const { return gap.has_strip ? gap.strip : gap.thing; }
  void confirm();
  void decide(Gap& gap, bool is_wall, bool is_wide) const;
  Vec2 place(const Ray& ray, double away_m) const;
  const Ray* ray_to(const Vec2& p_vehicle) const;
  bool is_floor(const Look& look, double level) const;
  std::optional<std::size_t> foot_of_thing(const Ray& ray, std::size_t thing) const;
  double texture_of_floor();
  double tolerance(double level) const;

  StandingThingParams params_;
  CameraMount mount_;
  int width_px_, height_px_;
  int columns_, rows_;
  double step_rad_ = 0, first_rad_ = 0;
  std::vector<Sample> samples_;
  std::vector<Ray> rays_;
  std::vector<Look> cells_;
  std::vector<Gap> gaps_;
  std::vector<Look> near_looks_;
  std::vector<StandingThing> things_;
  double mean_level_ = 0;
  double floor_level_ = -1;                 ///< where the picture begins; < 0: not known yet
  double red_green_ = 0, yellow_blue_ = 0;  ///< of the floor
  double texture_ = 0;                      ///< how much its level varies from place to place
};

}  // namespace aisle
