#include "aisle/matching/mwght.hpp"

#include "mwght_exhaustive.hpp"
#include "mwght_refinement.hpp"
#include "mwght_search.hpp"

namespace aisle {

void MwghtParams::describe(FieldList& fields) {
  fields.real("cell_m", cell_m, {0.002, 0.5}, "displacements are tried in steps of this");
  fields.angle("angle_step_deg", angle_step_rad, {0.01, 10}, "and angles in steps of this");
  fields.real("distance_scale_m", distance_scale_m, {0.01, 2},
              "D0: a pair this far off its place counts half");
  fields.real("reach_m", reach_m, {0, 1}, "a pair farther off its place does not count");
  fields.real("apart_m", apart_m, {0, 10}, "displacements farther apart than this are different hypotheses");
  fields.angle("apart_deg", apart_rad, {0, 180}, "and so are angles");
}

class Mwght::Work {
 public:
  explicit Work(const MwghtParams& params)
      : params_(params), kernel_(params), votes_(params), search_(kernel_), refinement_(params) {}

  std::optional<MwghtAnswer> by_branch_and_bound(std::span<const WeightedPoint> learned,
                                                 std::span<const WeightedPoint> seen,
                                                 const MwghtWindow& window) {
    const MwghtGrid grid(params_, window);
    votes_.gather(learned, seen, grid, kernel_.reach());
    search_.bound_squares(votes_, grid);
    return answer(search_, learned, seen, window);
  }

  std::optional<MwghtAnswer> exhaustively(std::span<const WeightedPoint> learned,
                                          std::span<const WeightedPoint> seen, const MwghtWindow& window) {
    const MwghtGrid grid(params_, window);
    votes_.gather(learned, seen, grid, kernel_.reach());
    array_.vote(votes_, grid, kernel_);
    return answer(array_, learned, seen, window);
  }

 private:
  template <class Maxima>
  std::optional<MwghtAnswer> answer(Maxima& maxima, std::span<const WeightedPoint> learned,
                                    std::span<const WeightedPoint> seen, const MwghtWindow& window) {
    const std::optional<MwghtMaximum> best = maxima.maximum();
    if (!best) return std::nullopt;
    const MwghtVicinity vicinity(params_, best->cell);
    const std::optional<MwghtMaximum> second = maxima.maximum(&vicinity);

    const auto refined = [&](const MwghtCell& cell) {
      return refinement_.refine(cell, learned, seen, window);
    };
    const UncertainPose2 displacement = refined(best->cell);
    MwghtAnswer answer{{best->cell, best->value, displacement.mean}, std::nullopt, displacement.covariance};
    if (second) answer.runner_up = MwghtPeak{second->cell, second->value, refined(second->cell).mean};
    return answer;
  }

  MwghtParams params_;
  MwghtKernel kernel_;
  MwghtVotes votes_;
  MwghtSearch search_;
  MwghtArray array_;
  MwghtRefinement refinement_;
};

Mwght::Mwght(const MwghtParams& params) : work_(std::make_unique<Work>(params)) {}
Mwght::Mwght(Mwght&&) noexcept = default;
Mwght::~Mwght() = default;

std::optional<MwghtAnswer> Mwght::match(std::span<const WeightedPoint> learned,
                                        std::span<const WeightedPoint> seen, const MwghtWindow& window) {
  return work_->by_branch_and_bound(learned, seen, window);
}

std::optional<MwghtAnswer> Mwght::match_exhaustively(std::span<const WeightedPoint> learned,
                                                     std::span<const WeightedPoint> seen,
                                                     const MwghtWindow& window) {
  return work_->exhaustively(learned, seen, window);
}

}  // namespace aisle
