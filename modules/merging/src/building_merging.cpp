#include "aisle/merging/building_merging.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <utility>

#include "aisle/matching/pose_graph.hpp"
#include "united_building.hpp"

namespace aisle {
namespace {

constexpr double kInSight_m = 6;  // with less wall in sight of both, two parts say nothing of each other
constexpr double kAxesSigma_rad = 0.02 * kDegree;
constexpr double kAgreementMin = 0.7;  // of two parts that were laid where others say

using Parts = std::span<const MapPart>;

std::vector<PartLink> links_between(const std::vector<MapPattern>& patterns, const MapAlignmentParams& params,
                                    Progress& progress) {
  std::vector<PartLink> links;
  const std::size_t pairs = patterns.size() * (patterns.size() - 1) / 2;
  for (std::size_t a = 0; a < patterns.size(); ++a) {
    for (std::size_t b = a + 1; b < patterns.size(); ++b) {
      progress.report("laying maps onto each other", links.size(), pairs);
      links.push_back({a, b, align_maps(patterns[a], patterns[b], params)});
    }
  }
  return links;
}

/// Every part at the end of a chain of links from the first; nullopt: none leads to it.
std::vector<std::optional<Pose2>> chained(std::size_t parts, const std::vector<PartLink>& links) {
  std::vector<std::optional<Pose2>> T_map_part(parts);
  T_map_part[0] = Pose2{};
  std::queue<std::size_t> open;
  const auto reach = [&](std::size_t part, const Pose2& T) {
    if (T_map_part[part]) return;
    T_map_part[part] = T;
    open.push(part);
  };
  for (open.push(0); !open.empty(); open.pop()) {
    const std::size_t part = open.front();
    for (const PartLink& link : links) {
      if (!link.alignment.is_found()) continue;
      const Pose2& T_first_second = link.alignment.best().T_fixed_moved;
      if (link.first == part) reach(link.second, *T_map_part[part] * T_first_second);
      if (link.second == part) reach(link.first, *T_map_part[part] * T_first_second.inverse());
    }
  }
  return T_map_part;
}

/// Why a part is at the end of no chain: what was found of it and the parts that are.
void say_why_apart(Parts parts, std::size_t part, const std::vector<std::optional<Pose2>>& T_map_part,
                   MergedBuilding& merged) {
  for (const PartLink& link : merged.links) {
    const bool leads_there =
        (link.first == part && T_map_part[link.second]) || (link.second == part && T_map_part[link.first]);
    if (!leads_there) continue;
    merged.why_refused.push_back(fmt::format("{} and {}: {}", parts[link.first].name, parts[link.second].name,
                                             reason_of(link.alignment)));
  }
}

/// Whether the axes of a part are those of the first one, or across them.
bool shares_axes(const Building& first, const Building& part, double turn_rad, double within_rad) {
  return first.has_dominant_direction && part.has_dominant_direction &&
         std::abs(wrap_quarter_turn(turn_rad)) < within_rad;
}

double nearest_quarter_turn(double turn_rad) {
  return wrap_angle(turn_rad - wrap_quarter_turn(turn_rad));
}

/// One pose graph over all parts. Maps whose axes are the same directions are turned by quarter turns only.
std::vector<Pose2> solved(Parts parts, const std::vector<std::optional<Pose2>>& guesses,
                          const std::vector<PartLink>& links, const MergeParams& params) {
  PoseGraph graph;
  std::vector<bool> is_upright;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Pose2 guess = *guesses[i];
    is_upright.push_back(
        shares_axes(parts.front().building, parts[i].building, guess.theta, params.upright_rad));
    if (is_upright[i]) guess.theta = nearest_quarter_turn(guess.theta);
    graph.add_node(guess);
    if (is_upright[i]) graph.add_heading_prior(i, guess.theta, kAxesSigma_rad);
  }
  for (const PartLink& link : links) {
    if (!link.alignment.is_found()) continue;
    const MapPlacement& best = link.alignment.best();
    graph.add_loop_closure({link.first, link.second, best.T_fixed_moved, best.information});
  }
  graph.optimise();
  std::vector<Pose2> T_map_part;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    T_map_part.push_back(graph.pose(i));
    if (is_upright[i]) T_map_part[i].theta = nearest_quarter_turn(T_map_part[i].theta);
  }
  return T_map_part;
}

/// What speaks against the solution: overlaps that it strains, and parts that would contradict each other.
std::vector<std::string> objections(Parts parts, const std::vector<MapPattern>& patterns,
                                    const MergedBuilding& merged, const MergeParams& params) {
  std::vector<std::string> all;
  for (const PartLink& link : merged.links) {
    const std::string names = fmt::format("{} and {}", parts[link.first].name, parts[link.second].name);
    const Pose2 T_first_second = between(merged.T_map_part[link.first], merged.T_map_part[link.second]);
    if (link.alignment.is_found()) {
      const Pose2 off = between(link.alignment.best().T_fixed_moved, T_first_second);
      if (off.position().norm() > params.strain_max_m || std::abs(off.theta) > params.strain_max_rad)
        all.push_back(fmt::format(
            "{}: the overlaps contradict each other; all together lay it {:.2f} m and {:.1f} degrees "
            "off this overlap",
            names, off.position().norm(), to_degrees(std::abs(off.theta))));
    }
    const MapOverlap overlap = overlap_of(patterns[link.first], patterns[link.second], T_first_second);
    if (overlap.common_m + overlap.denied_m > kInSight_m && overlap.agreement() < kAgreementMin)
      all.push_back(
          fmt::format("{}: where the other parts lay them, one denies {:.0f} m of walls that the other has",
                      names, overlap.denied_m));
  }
  return all;
}

}  // namespace

void MergeParams::describe(FieldList& fields) {
  fields.group("alignment", alignment);
  fields.real("strain_max_m", strain_max_m, {0.01, 10}, "by which overlaps that close a loop may disagree");
  fields.angle("strain_max_deg", strain_max_rad, {0.1, 45}, "likewise in heading");
  fields.angle("upright_deg", upright_rad, {0, 10},
               "axes of two maps within this of one another are the same");
}

MergedBuilding merge_buildings(Parts parts, const MergeParams& params, Progress& progress) {
  std::vector<MapPattern> patterns;
  patterns.reserve(parts.size());
  for (const MapPart& part : parts) patterns.emplace_back(part.building);
  MergedBuilding merged{.links = links_between(patterns, params.alignment, progress)};
  const auto guesses = chained(parts.size(), merged.links);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!guesses[i]) say_why_apart(parts, i, guesses, merged);
  }
  if (!merged.why_refused.empty()) return merged;
  merged.T_map_part = solved(parts, guesses, merged.links, params);
  merged.why_refused = objections(parts, patterns, merged, params);
  if (!merged.why_refused.empty()) {
    merged.T_map_part.clear();
    return merged;
  }
  merged.building = united_building(parts, merged.T_map_part, merged.notes);
  return merged;
}

}  // namespace aisle
