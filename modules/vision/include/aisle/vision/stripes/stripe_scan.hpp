#pragma once
/// Obstacles ahead as a polar scan, like a range scanner's: read from the stripe that the vehicle's line
/// lasers (C99 section 3.1: laser markers) draw on them.

#include <cstdint>
#include <optional>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/back_projection.hpp"
#include "aisle/geometry/camera_model.hpp"

namespace aisle {

struct StripeScanParams {
  double wide_m = 2.5;       ///< at this range the outermost beams are still in the image
  double sure_reach_m = 4;   ///< up to here a stripe is seen on all but grazing-incidence surfaces
  double light_reach_m = 8;  ///< up to here any wall shows that the lasers are on
  double contrast_min = 8;   ///< by which a stripe outshines what lies before and behind it [grey levels] ...
  double noise_factor = 4;   ///< ... and by how many times the image's usual contrast
  double beam_m = 0.006;     ///< thickness of the light
  double steepness_max = 2.5;   ///< of a stripe [rows per column]
  double width_min_m = 0.025;   ///< of the narrowest obstacle ...
  int beams_min = 3;            ///< ... and the least number of beams that hit it
  double mirrored_share = 0.5;  ///< of a stripe's contrast: a fainter one before it is its floor mirror image
  int lit_beams_min = 20;       ///< beams of a stripe that can only be laser light

  void describe(FieldList& fields);
};

/// Beams in the light plane from the point below the lens. Each is a curve in the image, on which every pixel
/// has its own distance. Where an obstacle stands in the light plane, the curve crosses a thin line that is
/// brighter than what lies before and behind it, and the neighbouring beams do so at about the same place.
class StripeScan {
 public:
  /// The reading of one beam.
  struct Beam {
    float range_m = 0;         ///< from below the lens to the laser return; 0: none within reach
    float near_m = 0;          ///< from here on, light on the beam would be seen ...
    float far_m = 0;           ///< ... up to here
    bool may_be_shut = false;  ///< no return, but a stripe fades out or leaves the image towards it
  };

  /// @param height_m  of the light plane above the floor
  /// @throws std::invalid_argument if the camera does not see the light plane from above
  StripeScan(const StripeScanParams& params, const CameraIntrinsics& intrinsics, const CameraMount& mount,
             int width_px, int height_px, double height_m);

  /// Angle of the first beam from the camera's direction; the others follow counter-clockwise, as many to the
  /// left as to the right.
  double first_angle_rad() const { return first_angle_rad_; }
  static double angle_step_rad();
  /// The beams with the readings of the last image.
  const std::vector<Beam>& beams() const { return beams_; }

  /// Reads one image.
  /// @throws std::invalid_argument unless the image is grey and of the camera's size
  const std::vector<Beam>& find(const Image& image);

  /// Whether the last image shows laser light at all, near or far.
  bool sees_light() const { return sees_light_; }

  /// Appends the last image's laser returns within sure_reach_m, in base_link [m], from right to left.
  void append_lit(std::vector<Vec2>& p_vehicle_returns) const;

  /// Whether the last image shows that nothing stands in the light plane at a point of base_link: the plane
  /// is in view there and beyond. What is out of view, beyond sure_reach_m or hidden is not known to be free.
  bool is_free(const Vec2& p_vehicle) const;

 private:
  /// A point on a beam: four pixels and their weights.
  struct Sample {
    std::uint32_t first_byte = 0;
    std::uint16_t right_256 = 0, below_256 = 0;
    float range_m = 0;
    std::uint8_t flank = 0;  ///< samples from a stripe's middle to beside it
  };
  struct Curve {
    std::size_t first = 0, end = 0;  ///< of `samples_`
  };
  struct Peak {
    std::size_t beam = 0;
    std::size_t sample = 0;
    int row = 0;
    double range_m = 0;
    int contrast = 0;
    int rows = 0;                 ///< along the beam, at least half as bright
    std::optional<double> slope;  ///< rows per beam, of the stripe up to here
    std::size_t chain = 0;
  };
  struct Chain {
    std::size_t first_peak = 0, last_peak = 0;  ///< others may lie between
    int beams = 0;
    int peaks = 0;         ///< a beam may cross it twice
    int contrast = 0;      ///< of all its peaks together
    double range_m = 0;    ///< the nearest
    double thickness = 0;  ///< sum over its peaks, each as a share of what laser light has there
    bool is_stripe = false;
  };

  void lay_beams(const CameraModel& camera, const CameraMount& mount, double height_m);
  void lay_curve(double angle_rad, const CameraModel& camera, const CameraMount& mount, double height_m);
  bool is_inside(const Vec2& pixel) const;
  void read(const Image& image);
  std::uint8_t flank_at(double away_m) const;
  int threshold() const;
  void find_peaks();
  int brightest_beside(const Curve& curve, std::size_t i) const;
  void add_peak(std::size_t beam, std::size_t i, int contrast);
  void link_peaks();
  const Peak* linked_before(const Peak& peak, std::size_t first) const;
  double thickness(const Peak& peak) const;
  bool is_stripe(std::size_t c) const;
  bool outshines_grain(std::size_t c) const;
  void choose_nearest();
  void mark_uncertain_beyond_ends();
  void mark_uncertain_beyond(int end, int outwards);
  bool goes_on_unseen(int end, int inwards, int beams) const;
  int beams_of_wall(int end, int inwards) const;
  Vec2 hit(int beam) const;

  StripeScanParams params_;
  Pose2 T_vehicle_fan_;  ///< below the lens, where the camera looks
  int width_px_, height_px_;
  double focal_px_;
  double above_m_;   ///< the lens, over the light plane
  int link_px_ = 0;  ///< rows from beam to beam of one stripe, at most
  double first_angle_rad_ = 0;
  std::vector<Sample> samples_;
  std::vector<Curve> curves_;
  std::vector<Beam> beams_;
  std::vector<std::int16_t> levels_;  ///< one per sample
  std::vector<Peak> peaks_;
  std::vector<Chain> chains_;
  std::vector<int> brightest_;  ///< one per beam
  std::vector<int> contrast_;   ///< one per beam, of what it hits
  int contrast_min_ = 0;
  bool sees_light_ = false;
};

}  // namespace aisle
