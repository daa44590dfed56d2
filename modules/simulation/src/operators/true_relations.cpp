#include "aisle/simulation/operators/true_relations.hpp"

#include <fmt/format.h>

#include <iterator>

namespace aisle {
namespace {

constexpr double kSpacing_m = 1;
constexpr double kNear_m = 1;          ///< a revisit comes at least this near
constexpr double kTravelledMin_m = 8;  ///< ... after at least this distance travelled

/// The scan that represents one metre of the drive.
struct Milestone {
  std::size_t scan = 0;
  double travelled_m = 0;
};

std::vector<Milestone> milestones(std::span<const Pose2> poses) {
  std::vector<Milestone> found;
  double travelled_m = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (i > 0) travelled_m += (poses[i].position() - poses[i - 1].position()).norm();
    if (found.empty() || travelled_m >= found.back().travelled_m + kSpacing_m)
      found.push_back({i, travelled_m});
  }
  return found;
}

}  // namespace

std::vector<PoseRelation> true_relations(std::span<const Pose2> T_world_vehicle, Random& random) {
  const std::vector<Milestone> stones = milestones(T_world_vehicle);
  std::vector<PoseRelation> relations;
  const auto relate = [&](const Milestone& a, const Milestone& b) {
    relations.push_back({a.scan, b.scan, between(T_world_vehicle[a.scan], T_world_vehicle[b.scan])});
  };
  for (std::size_t a = 0; a + 1 < stones.size(); ++a) {
    relate(stones[a], stones[a + 1]);
    std::vector<std::size_t> revisits;
    for (std::size_t b = a + 1; b < stones.size(); ++b) {
      const Vec2 apart =
          T_world_vehicle[stones[b].scan].position() - T_world_vehicle[stones[a].scan].position();
      if (stones[b].travelled_m - stones[a].travelled_m >= kTravelledMin_m && apart.norm() <= kNear_m)
        revisits.push_back(b);
    }
    if (!revisits.empty()) relate(stones[a], stones[revisits[random.index(revisits.size())]]);
  }
  return relations;
}

std::string relations_text(std::span<const PoseRelation> relations) {
  std::string text = "# i1 i2 x_m y_m yaw_rad   (scans by number from 0; the second seen from the first)\n";
  for (const PoseRelation& relation : relations) {
    const Pose2& T = relation.T_1_2;
    fmt::format_to(std::back_inserter(text), "{} {} {:.6f} {:.6f} {:.6f}\n", relation.scan_1, relation.scan_2,
                   T.x, T.y, T.theta);
  }
  return text;
}

}  // namespace aisle
