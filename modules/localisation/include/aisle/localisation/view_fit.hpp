#pragma once
/// How well what was seen fits a building, if the vehicle stood at a certain pose.

#include <span>

#include "aisle/localisation/local_view.hpp"
#include "aisle/localisation/surface_field.hpp"

namespace aisle {

struct ViewFitParams {
  double on_m = 0.05;      ///< a hit this near to a surface is on it: maps err by so much
  double near_m = 0.15;    ///< a hit this near to a surface is explained by it
  double beyond_m = 0.25;  ///< a beam that gets this far off a surface that it crossed went through it
  double through_weight = 2;

  void describe(FieldList& fields);
};

/// What became of each beam of a view at a pose.
struct ViewFit {
  int beams = 0;
  int explained = 0;    ///< ended at a surface of the building
  int through = 0;      ///< went through one; all others ended where the building has none
  int unknown = 0;      ///< of these others: where the building is not known either
  double misfit_m = 0;  ///< surface that is not explained, weighted
  double chance_m = 0;  ///< the same with squared weights: chance makes the misfit vary by its square root

  /// Of the beams that the building says anything about.
  double explained_share_of_known() const {
    return beams > unknown ? static_cast<double>(explained) / (beams - unknown) : 1;
  }
  double explained_share() const { return beams > 0 ? static_cast<double>(explained) / beams : 0; }
};

/// @param beams   in the vehicle's frame
/// @param piece_m  surface that each stands for
ViewFit fit_of(const SurfaceField& field, std::span<const ViewBeam> beams, double piece_m,
               const Pose2& T_map_vehicle, const ViewFitParams& params);

/// A pose laid onto the building's surfaces.
struct SurfaceAlignment {
  Pose2 T_map_vehicle;
  Mat3 information = Mat3::Zero();  ///< of (x, y, theta), from the surfaces alone
  double near_share = 0;            ///< of the points that a surface explains
};

/// Gauss-Newton on each point's distance from the nearest surface, with a Cauchy weight, and on the guess.
/// Cost O(points); no allocation.
/// @param hits               in the vehicle's frame
/// @param p_laser            scanner, in the vehicle's frame: walls that face away from it are not matched
/// @param guess_information  of the guess; zero: it is only where the search begins
SurfaceAlignment align_to_surfaces(const SurfaceField& field, std::span<const Vec2> hits, const Vec2& p_laser,
                                   const Pose2& guess, const Mat3& guess_information);

}  // namespace aisle
