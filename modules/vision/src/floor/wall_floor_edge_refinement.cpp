#include "floor/wall_floor_edge_refinement.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {

namespace {

constexpr double kShiftMax = 9.0 / 640;  // greatest shift, as a share of the width
constexpr double kTurn = 0.8;            // greatest difference of the shifts at both ends, of the reach
constexpr double kShortest = 0.06;       // a shorter line is left as it is: share of the width
constexpr std::size_t kSamplesMax = 120;
constexpr double kSampleStep_px = 2;
constexpr std::size_t kAveraged = 2;    // neighbouring profiles on either side in the average
constexpr std::size_t kMargin = 3;      // pixels on either side that a step is the difference of
constexpr float kStepMin = 4;           // grey levels
constexpr float kStepCounted = 25;      // the most that one step counts, so that it does not outvote many
constexpr float kPlateau = 1.25F;       // a step that is this close to its greater neighbour counts half
constexpr double kFarShiftCost = 0.25;  // share of the votes that the greatest shift loses
constexpr double kMeanVoteMin = 2;      // grey levels
constexpr double kLikeVotes = 0.9;
constexpr double kOtherVotes = 0.4;
constexpr std::size_t kSettle = 2;  // pixels to either side in which a line's own step lies
constexpr int kSettleRounds = 3;
constexpr float kOutside = -1;
constexpr double kLowerPerVotes = 60;  // steps that all the votes are worth

bool has_neighbours(const SideView& view, const Vec2& at) {
  return at.x() >= 0 && at.y() >= 0 && at.x() < view.width_px() - 1 && at.y() < view.height_px() - 1;
}

}  // namespace

void WallFloorEdgeRefinement::refine(const SideView& view, double from_px, double to_px,
                                     WallFloorEdge& edge) {
  if (to_px - from_px < kShortest * view.width_px()) return;
  measure_steps(view, from_px, to_px, edge);
  shifts_.clear();
  for (const std::size_t side : {0U, 1U}) vote(side, edge.has_clear_sign() && (edge.sign < 0) != (side == 1));
  const Shift* shift = lowest_of_like_votes();
  if (shift == nullptr) return;
  const std::size_t side = shift->side;
  move(settled(*shift), from_px, to_px, edge);
  // The edge may lie beyond the reach at one end: it is searched again around the moved line.
  measure_steps(view, from_px, to_px, edge);
  shifts_.clear();
  vote(side, false);
  shift = most_voted();
  if (shift != nullptr) move(settled(*shift), from_px, to_px, edge);
}

void WallFloorEdgeRefinement::move(const Shifts_px& shifts_px, double from_px, double to_px,
                                   WallFloorEdge& edge) {
  const Vec2 beneath = left_normal(edge.direction);
  const Vec2 from = edge.point_px + from_px * edge.direction + shifts_px.first * beneath;
  const Vec2 to = edge.point_px + to_px * edge.direction + shifts_px.second * beneath;
  edge.point_px = from - from_px * (to - from).normalized();
  edge.direction = (to - from).normalized();
}

void WallFloorEdgeRefinement::measure_steps(const SideView& view, double from_px, double to_px,
                                            const WallFloorEdge& edge) {
  reach_ = static_cast<std::size_t>(std::lround(kShiftMax * view.width_px()));
  across_ = 2 * reach_ + 1;
  along_ = std::min(kSamplesMax, static_cast<std::size_t>((to_px - from_px) / kSampleStep_px));
  for (auto& steps : steps_) steps.assign(along_ * across_, 0);
  for (auto& edges : edges_) edges.assign(along_ * across_, 0);
  sample_profiles(view, from_px, to_px, edge);
  for (std::size_t i = 0; i < along_; ++i) {
    average_profile(i);
    for (std::size_t k = 0; k < across_; ++k) {
      const float* p = profile_.data() + k + kMargin;
      if (p[-3] == kOutside) continue;
      const float difference = p[1] - p[-1];
      edges_[difference < 0 ? 1 : 0][i * across_ + k] = std::abs(difference);
      const float step = (p[1] + p[2] + p[3] - p[-1] - p[-2] - p[-3]) / 3;
      if (std::abs(step) < kStepMin) continue;
      steps_[step < 0 ? 1 : 0][i * across_ + k] = std::abs(step);
    }
  }
  for (auto& steps : steps_) {
    thin(steps);
    for (float& step : steps) step = std::min(step, kStepCounted);
  }
}

void WallFloorEdgeRefinement::sample_profiles(const SideView& view, double from_px, double to_px,
                                              const WallFloorEdge& edge) {
  profile_.resize(across_ + 2 * kMargin);
  profiles_.resize(along_ * profile_.size());
  const Vec2 beneath = left_normal(edge.direction);
  const double outermost = static_cast<double>(reach_ + kMargin);
  float* value = profiles_.data();
  for (std::size_t i = 0; i < along_; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(along_);
    Vec2 at = edge.point_px + (from_px + share * (to_px - from_px)) * edge.direction - outermost * beneath;
    float last = kOutside;
    for (std::size_t k = 0; k < profile_.size(); ++k) {
      if (has_neighbours(view, at)) last = static_cast<float>(view.between(at));
      *value++ = last;
      at += beneath;
    }
  }
}

/// Averaging along the line keeps its own edges and fades those that cross it, such as door frames and tile
/// joints.
void WallFloorEdgeRefinement::average_profile(std::size_t i) {
  const std::size_t first = i - std::min(i, kAveraged), last = std::min(i + kAveraged, along_ - 1);
  for (std::size_t k = 0; k < profile_.size(); ++k) {
    profile_[k] = profiles_[i * profile_.size() + k];
    if (profile_[k] == kOutside) continue;
    float sum = 0, count = 0;
    for (std::size_t j = first; j <= last; ++j) {
      const float value = profiles_[j * profile_.size() + k];
      if (value == kOutside) continue;
      sum += value;
      count += 1;
    }
    profile_[k] = sum / count;
  }
}

/// Keeps the greatest of neighbouring steps.
void WallFloorEdgeRefinement::thin(std::vector<float>& steps) const {
  for (std::size_t row = 0; row < steps.size(); row += across_) {
    float before = 0;
    for (std::size_t k = 0; k < across_; ++k) {
      const float here = steps[row + k];
      const float greater = std::max(before, k + 1 < across_ ? steps[row + k + 1] : 0);
      if (here < greater) steps[row + k] = greater < kPlateau * here ? 0.5F * here : 0;
      before = here;
    }
  }
}

/// @param other_edge  of the board: it may be found beneath the line, not above it
void WallFloorEdgeRefinement::vote(std::size_t side, bool other_edge) {
  const auto turn = static_cast<std::size_t>(kTurn * static_cast<double>(reach_));
  const auto off = [this](std::size_t k) {
    return std::abs(static_cast<double>(k) - static_cast<double>(reach_));
  };
  for (std::size_t a = 0; a < across_; ++a) {
    for (std::size_t b = a > turn ? a - turn : 0; b < std::min(across_, a + turn + 1); ++b) {
      if (other_edge && a + b <= 2 * reach_) continue;
      const float per_sample = (static_cast<float>(b) - static_cast<float>(a)) / static_cast<float>(along_);
      float k = static_cast<float>(a) + 0.5F * per_sample + 0.5F;
      float sum = 0;
      for (const float* row = steps_[side].data(); row != steps_[side].data() + along_ * across_;
           row += across_) {
        sum += row[static_cast<int>(k)];
        k += per_sample;
      }
      const double shift = (off(a) + off(b)) / (2.0 * static_cast<double>(reach_));
      shifts_.push_back({a, b, side, sum * (1 - kFarShiftCost * shift), other_edge});
    }
  }
}

const WallFloorEdgeRefinement::Shift* WallFloorEdgeRefinement::most_voted() const {
  const auto most = std::max_element(shifts_.begin(), shifts_.end(),
                                     [](const Shift& a, const Shift& b) { return a.votes < b.votes; });
  if (most == shifts_.end() || most->votes < kMeanVoteMin * static_cast<double>(along_)) return nullptr;
  return &*most;
}

const WallFloorEdgeRefinement::Shift* WallFloorEdgeRefinement::lowest_of_like_votes() const {
  const Shift* most = most_voted();
  if (most == nullptr) return nullptr;
  const Shift* other = nullptr;
  for (const Shift& shift : shifts_)
    if (shift.other_edge && (other == nullptr || shift.votes > other->votes)) other = &shift;
  if (other != nullptr && other->votes > kOtherVotes * most->votes) return other;
  const Shift* lowest = nullptr;
  double best = 0;
  for (const Shift& shift : shifts_) {
    if (shift.votes < kLikeVotes * most->votes) continue;
    const double low =
        static_cast<double>(shift.at_from + shift.at_to) + kLowerPerVotes * shift.votes / most->votes;
    if (low > best) {
      best = low;
      lowest = &shift;
    }
  }
  return lowest;
}

/// A shift is a whole number of pixels, and the lowest of several: the line moves to the middle of its step.
WallFloorEdgeRefinement::Shifts_px WallFloorEdgeRefinement::settled(const Shift& shift) const {
  const auto reach_px = static_cast<double>(reach_);
  Shifts_px shifts_px(static_cast<double>(shift.at_from) - reach_px,
                      static_cast<double>(shift.at_to) - reach_px);
  for (int round = 0; round < kSettleRounds; ++round) shifts_px = between_steps(shifts_px, shift.side);
  return shifts_px;
}

/// The line through the middles of the edges next to a shifted line, as its shifts. The steps that vote are
/// not precise enough: far away, where a board is thinner than the margin, their middle is beneath its edge.
WallFloorEdgeRefinement::Shifts_px WallFloorEdgeRefinement::between_steps(const Shifts_px& shifts_px,
                                                                          std::size_t side) const {
  const auto& edges = edges_[side];
  const double first = shifts_px.first + static_cast<double>(reach_);
  const double turn = shifts_px.second - shifts_px.first;
  double weights = 0, shares = 0, offs = 0, shares_squared = 0, products = 0;
  for (std::size_t i = 0; i < along_; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(along_);
    const auto middle = static_cast<std::size_t>(std::max(0L, std::lround(first + turn * share)));
    if (middle < kSettle || middle + kSettle >= across_) continue;
    double weight = 0, moment = 0;
    for (std::size_t k = middle - kSettle; k <= middle + kSettle; ++k) {
      weight += edges[i * across_ + k];
      moment += edges[i * across_ + k] * static_cast<double>(k);
    }
    if (weight == 0) continue;
    const double off = moment / weight - first - turn * share;
    weight = std::min<double>(weight, kStepCounted);
    weights += weight;
    shares += weight * share;
    offs += weight * off;
    shares_squared += weight * share * share;
    products += weight * share * off;
  }
  const double spread = weights * shares_squared - shares * shares;
  const double middle_px = first - static_cast<double>(reach_);
  if (!(spread > 1e-3 * weights * weights)) return {middle_px, middle_px + turn};
  const double growth = (weights * products - shares * offs) / spread;
  const double at_from = (offs - growth * shares) / weights;
  return {middle_px + at_from, middle_px + turn + at_from + growth};
}

}  // namespace aisle
