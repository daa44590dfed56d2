#pragma once

#include <optional>
#include <span>
#include <vector>

#include "aisle/geometry/pose2.hpp"
#include "aisle/guidance/odometry_correction.hpp"

namespace aisle {

/// Calibrates the odometry while driving: from image to image, the edges of the free floor must move as the
/// wheels say. It needs no map, so what was moved since the route was taught does no harm. Straight walls
/// beside the vehicle tell nothing of the distance; along them it learns only the steering's bias.
///
/// An agile Kalman filter follows whatever happens to the wheels. What they report is believed until that
/// filter surely differs; from then on, a steady filter goes on from its estimate.
class OdometryCalibration {
 public:
  explicit OdometryCalibration(const FrontSteered& vehicle) : vehicle_(vehicle) {}

  /// One cycle's motion up to a time, as reported and as commanded.
  void move(double stamp_s, const FrontSteeredMotion& reported, double commanded_m);
  /// The edges that an image shows.
  /// @param p_vehicle  in base_link; neighbours on an edge are neighbours here
  void look(double stamp_s, std::span<const Vec2> p_vehicle);

  /// Changes nothing until it is sure that the wheels misreport.
  OdometryCorrection correction() const { return steady_ ? steady_->error : OdometryCorrection{}; }
  bool has_correction() const { return steady_.has_value(); }
  /// Since when the motions need it, as far as it can tell.
  double correction_from_s() const { return correction_from_s_; }
  /// Whether what was seen can still be told from wheels that misreport.
  bool is_plausible() const;

 private:
  struct Motion {
    double stamp_s = 0;
    FrontSteeredMotion reported;
    double commanded_m = 0;
  };
  struct Edge {
    Vec2 p_vehicle = Vec2::Zero();
    Vec2 normal = Vec2::Zero();
  };
  struct Estimate {
    OdometryCorrection error;
    Mat2 covariance = Mat2::Zero();  ///< of the distance factor and the bias
    double cost = 0;                 ///< negative logarithm of its likelihood
  };
  /// How well the edges of two images agree, given an error of the odometry between them.
  struct Agreement {
    int matches = 0;
    double cost = 0;  ///< half the squares of the deviations, robust, in standard deviations
    Vec2 gradient = Vec2::Zero();
    Mat2 information = Mat2::Zero();
  };

  static Estimate fused(const Estimate& one, const Estimate& other);
  static bool surely_differ(const Estimate& one, const Estimate& other);
  double path_from_key_m(double stamp_s) const;
  double commanded_from_key_m(double stamp_s) const;
  Pose2 T_key_vehicle(double stamp_s, const OdometryCorrection& error) const;
  void begin_at(double stamp_s, std::span<const Vec2> p_vehicle);
  void measure(double path_m, double stamp_s, std::span<const Vec2> p_vehicle);
  std::optional<Estimate> follow(double path_m, double stamp_s, std::span<const Vec2> p_vehicle);
  std::optional<Estimate> updated(const Estimate& prior, const OdometryCorrection& first, double stamp_s,
                                  std::span<const Vec2> p_vehicle) const;
  Agreement compared(double stamp_s, std::span<const Vec2> p_vehicle, const OdometryCorrection& error) const;

  FrontSteered vehicle_;
  double key_s_ = 0;
  std::vector<Edge> key_;        ///< edges of the key image, with which the next one is compared
  double key_nearest_m_ = 0;     ///< of its edges, from base_link
  std::vector<Motion> motions_;  ///< since then, the oldest first
  Estimate agile_;
  std::optional<Estimate> steady_;
  int off_ = 0;  ///< measurements in a row by which the agile filter differs, one like the other ...
  double off_from_s_ = 0;  ///< ... and the key image of the first
  double correction_from_s_ = 0;
};

}  // namespace aisle
