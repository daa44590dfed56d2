#pragma once
/// Maps of one building, each in a frame of its own, made into one.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/merging/map_alignment.hpp"

namespace aisle {

struct MergeParams {
  /// Between maps of one time, walls do not come and go; doors do, and what is narrower.
  MapAlignmentParams alignment{.agreement_min = 0.85, .allows_changes = false};
  double strain_max_m = 0.3;  ///< by which overlaps that close a loop may disagree
  double strain_max_rad = 2 * kDegree;
  double upright_rad = 1 * kDegree;  ///< axes of two maps within this of one another are the same

  void describe(FieldList& fields);
};

/// A building of which others show more.
struct MapPart {
  std::string name;  ///< for messages, and for what has the same name in another part
  Building building;
};

/// What was found of two of the parts.
struct PartLink {
  std::size_t first = 0;
  std::size_t second = 0;
  MapAlignment alignment;
};

struct MergedBuilding {
  std::vector<PartLink> links;           ///< of every two parts
  std::vector<Pose2> T_map_part;         ///< empty if refused
  std::optional<Building> building;      ///< in the frame of the first part; none: refused
  std::vector<std::string> why_refused;  ///< what is wrong, and between which parts
  std::vector<std::string> notes;        ///< what of the parts was renamed or left out
};

/// Finds the overlaps of all parts, and solves one pose graph over all of them. Refused, and said why, where
/// a part's place is ambiguous or unknown, where overlaps contradict each other, and where two parts would
/// lie on one another and not agree. Places, routes, zones, lines and landmarks are carried over; a name that
/// another part has, too, gets the part's name behind it. Landmarks of another camera than the first part's
/// are left out.
/// @param parts  each with walls and a floor; names are unique
/// @throws std::invalid_argument if a part has neither walls nor occupied floor, or is too large
MergedBuilding merge_buildings(std::span<const MapPart> parts, const MergeParams& params, Progress& progress);

}  // namespace aisle
