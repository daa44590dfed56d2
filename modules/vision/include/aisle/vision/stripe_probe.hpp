#pragma once
/// Where things stand ahead, by the stripe that the vehicle's laser markers draw on them.

#include <array>
#include <cstdint>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/back_projection.hpp"
#include "aisle/geometry/camera_model.hpp"

namespace aisle {

struct StripeProbeParams {
  double reach_m = 2.5;
  double light_reach_m = 8;
  int flank_px = 3;
  double contrast_min = 10;
  double noise_factor = 6;
  int columns_min = 6;
  double columns_per_m = 5.5;
  double mirrored_share = 0.5;

  void describe(FieldList& fields);
};

/// Looks for laser light at the places of a picture where it can be from below the picture up to a few
/// metres away, quickly enough for every cycle. Each row of a column belongs to one distance. Laser light is
/// a thin bright line across: as much brighter than what is a few rows above as than what is a few rows
/// below. Paper on the floor is too thick for that within reach, and its corners grow thick. No allocation
/// once warm.
class StripeProbe {
 public:
  /// @param height_m  of the light plane above the floor
  /// @throws std::invalid_argument if the camera does not see the light plane from above within reach
  StripeProbe(const StripeProbeParams& params, const CameraIntrinsics& intrinsics, const CameraMount& mount,
              int width_px, int height_px, double height_m);

  /// Places lit by the laser [m, vehicle frame], by column from the left; valid until the next call.
  /// @throws std::invalid_argument unless the picture is grey and of the camera's size
  const std::vector<Vec2>& find(const Image& picture);

  /// Whether the last picture shows laser light at all, near or far.
  bool sees_light() const { return sees_light_; }

  enum class Seen {
    kFree,     ///< the light plane is in view there and beyond, with nothing in it
    kNothing,  ///< nothing is known: out of view, or hidden
  };
  /// What the last picture says of a place.
  Seen seen_at(const Vec2& p_vehicle) const;

 private:
  struct Peak {
    int row = 0;
    int contrast = 0;
    int rows = 0;  ///< that are at least half as bright, as far as looked at
    std::size_t chain = 0;
  };
  static constexpr std::size_t kPeaksMax = 6;    ///< of a column
  static constexpr std::size_t kEndColumns = 3;  ///< of a chain
  struct Column {
    int first_row = 0, end_row = 0;  ///< where the light plane is within reach
    std::size_t first_place = 0;
    std::array<Peak, kPeaksMax> peaks;
    std::size_t peaks_found = 0;
    double free_m = 0;  ///< from the lens, over the floor
  };
  /// Peaks of neighbouring columns at about the same row.
  struct Chain {
    double away_m = 0;  ///< from the lens, over the floor
    int columns = 0;
    std::array<int, kEndColumns> last_rows{};  ///< Peak::rows of its last peaks
    bool is_stripe = true;
  };

  void lay_columns(const CameraModel& camera);
  int threshold(const Image& picture) const;
  int rows_as_bright(const Image& picture, int u, int v, int level) const;
  void find_peaks(const Image& picture);
  void link_peaks();
  const Peak* peak_before(std::size_t column, int row) const;
  bool is_stripe(const Chain& chain) const;
  void collect();
  const Peak* nearest_light(const Column& column) const;
  const Vec2& place(const Column& column, int row) const;
  double away_m(const Vec2& p_vehicle) const { return (p_vehicle - p_vehicle_lens_).norm(); }

  StripeProbeParams params_;
  CameraModel camera_;
  CameraMount mount_;
  int width_px_, height_px_;
  double height_m_;
  Vec2 p_vehicle_lens_;
  int first_row_ = 0;  ///< of all columns
  std::vector<Column> columns_;
  std::vector<Vec2> places_;  ///< of each row of each column
  std::vector<Chain> chains_;
  std::vector<Vec2> found_;
  bool sees_light_ = false;
};

}  // namespace aisle
