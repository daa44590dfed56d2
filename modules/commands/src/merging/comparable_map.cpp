#include "merging/comparable_map.hpp"

#include "aisle/commands/known_building.hpp"
#include "aisle/core/rounded.hpp"

namespace aisle {
namespace {

const char* name_of(AlignmentVerdict verdict) {
  switch (verdict) {
    case AlignmentVerdict::kFound:
      return "found";
    case AlignmentVerdict::kAmbiguous:
      return "ambiguous";
    case AlignmentVerdict::kApart:
      return "apart";
    case AlignmentVerdict::kUnsearched:
      break;
  }
  return "unsearched";
}

}  // namespace

Problems not_comparable(const Building& building, const std::filesystem::path& file) {
  Problems problems;
  if (building.walls.walls.empty())
    problems.push_back({{file.string(), 0, "walls"}, "are missing: nothing can be recognised"});
  if (!building.floor || building.floor->count(Floor::kFree) == 0)
    problems.push_back({{file.string(), 0, "floor"},
                        "is missing: what has gone cannot be told from what was not seen; maps of logs "
                        "have one (`aisle map` without --no-floor), and explored buildings"});
  return problems;
}

Result<Building> read_comparable_map(const std::filesystem::path& file, Console& console) {
  auto building = read_known_building(file, console);
  if (!building) return building;
  if (Problems problems = not_comparable(*building, file); !problems.empty()) return problems;
  return building;
}

nlohmann::ordered_json placement_json(const Pose2& T) {
  return {
      {"x_m", rounded(T.x, 3)}, {"y_m", rounded(T.y, 3)}, {"heading_deg", rounded(to_degrees(T.theta), 3)}};
}

nlohmann::ordered_json alignment_json(const MapAlignment& alignment) {
  nlohmann::ordered_json figures = {{"verdict", name_of(alignment.verdict)},
                                    {"reason", reason_of(alignment)}};
  if (alignment.placements.empty()) return figures;
  const MapPlacement& best = alignment.best();
  figures["common_m"] = rounded(best.overlap.common_m, 1);
  figures["denied_m"] = rounded(best.overlap.denied_m, 1);
  figures["agreement"] = rounded(best.overlap.agreement(), 3);
  figures["rival_share"] = rounded(alignment.rival_share, 3);
  if (!alignment.is_found()) return figures;
  figures.update(placement_json(best.T_fixed_moved));
  figures["sigma_m"] = rounded(best.sigma_m(), 4);
  figures["sigma_deg"] = rounded(to_degrees(best.sigma_rad()), 4);
  return figures;
}

}  // namespace aisle
