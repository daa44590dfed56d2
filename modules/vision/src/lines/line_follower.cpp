#include "aisle/vision/lines/line_follower.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace aisle {
namespace {

/// Mean grey level along a line, 1 .. 2 % of the width beside it.
double tone_beside(const Image& grey, const VerticalLine& line, int side) {
  constexpr int kAlong = 24, kAcross = 4;
  const Vec2 along = line.bottom_px - line.top_px;
  double sum = 0;
  for (int i = 0; i < kAlong; ++i) {
    const Vec2 p = line.top_px + (i + 0.5) / kAlong * along;
    for (int j = 0; j < kAcross; ++j) {
      const double u = p.x() + side * grey.width_px * (0.01 + 0.01 * j / kAcross);
      const int column = std::clamp(static_cast<int>(std::lround(u)), 0, grey.width_px - 1);
      const int row = std::clamp(static_cast<int>(std::lround(p.y())), 0, grey.height_px - 1);
      sum += grey.row(row)[column];
    }
  }
  return sum / (kAlong * kAcross);
}

LineLook look_of(const Image& grey, const VerticalLine& line) {
  const Vec2 along = line.bottom_px - line.top_px;
  const double slope = along.y() > 0 ? along.x() / along.y() : 0;
  const double column_px = line.top_px.x() + slope * (grey.height_px / 2.0 - line.top_px.y());
  return {column_px / grey.width_px - 0.5, slope, tone_beside(grey, line, -1), tone_beside(grey, line, 1)};
}

/// How the camera moved between two images.
struct Motion {
  double end_before = 0;  ///< column of the corridor's end
  double end_now = 0;
  double approach = 0;

  /// @return outside the image for what the camera has passed
  double expected(double column) const {
    const double x = column - end_before;
    const double nearer = 1 - approach * std::abs(x);
    return nearer > 0.1 ? end_now + x / nearer : 10;
  }
};

/// The lines of two images, paired in order.
struct Pairing {
  double worth = 0;  // sum of their likenesses, less the cost of the motion
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
};

/// Matches the lines of one image with those of the next.
class Comparison {
 public:
  Comparison(const std::vector<LineLook>& before, const std::vector<LineLook>& now,
             const LineFollowerParams& params);

  Pairing best_pairing(const std::vector<Motion>& motions);

 private:
  /// Two lines that are alike but for their column.
  struct Candidate {
    std::size_t before;
    std::size_t now;
    double like;
  };
  /// One of them, after the best pairs farther left that it does not cross.
  struct Link {
    std::size_t before;
    std::size_t now;
    double worth;      // including theirs
    std::size_t left;  // the next of them; itself: none
  };

  double compare(const Motion& motion);
  std::vector<std::pair<std::size_t, std::size_t>> pairs(const Motion& motion);

  const std::vector<LineLook>& before_;
  const std::vector<LineLook>& now_;
  const LineFollowerParams& params_;
  std::vector<Candidate> candidates_;  // from left to right by the line before
  std::vector<Link> links_;            // of the latest motion
};

double squared_share(double difference, double gate) {
  return difference * difference / (gate * gate);
}

/// 1: just alike; negative: another line.
double likeness(const LineLook& before, const LineLook& now, const LineFollowerParams& params) {
  if (before.brighter_right() != now.brighter_right()) return -1;
  return 1 - squared_share(now.slope - before.slope, params.slope_gate) -
         squared_share(now.tone_left - before.tone_left, params.tone_gate) -
         squared_share(now.tone_right - before.tone_right, params.tone_gate);
}

Comparison::Comparison(const std::vector<LineLook>& before, const std::vector<LineLook>& now,
                       const LineFollowerParams& params)
    : before_(before), now_(now), params_(params) {
  for (std::size_t i = 0; i < before.size(); ++i) {
    for (std::size_t j = 0; j < now.size(); ++j) {
      const double like = likeness(before[i], now[j], params);
      if (like > 0) candidates_.push_back({i, j, like});
    }
  }
}

/// The greatest sum of likenesses of pairs that do not cross.
double Comparison::compare(const Motion& motion) {
  links_.clear();
  double best = 0;
  for (const Candidate& candidate : candidates_) {
    const double expected = motion.expected(before_[candidate.before].column);
    const double off = squared_share(now_[candidate.now].column - expected, params_.gate);
    if (off >= candidate.like) continue;
    Link link{candidate.before, candidate.now, 0, links_.size()};
    for (std::size_t k = 0; k < links_.size(); ++k) {
      const Link& left = links_[k];
      if (left.before >= link.before || left.now >= link.now || left.worth <= link.worth) continue;
      link.worth = left.worth;
      link.left = k;
    }
    link.worth += candidate.like - off;
    best = std::max(best, link.worth);
    links_.push_back(link);
  }
  return best;
}

std::vector<std::pair<std::size_t, std::size_t>> Comparison::pairs(const Motion& motion) {
  compare(motion);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  const auto last = std::max_element(links_.begin(), links_.end(),
                                     [](const Link& a, const Link& b) { return a.worth < b.worth; });
  if (last == links_.end()) return pairs;
  for (auto k = static_cast<std::size_t>(last - links_.begin());; k = links_[k].left) {
    pairs.emplace_back(links_[k].before, links_[k].now);
    if (links_[k].left == k) return pairs;
  }
}

/// All motions that are tried, the finer the slower the approach.
std::vector<Motion> possible_motions(const LineFollowerParams& params) {
  constexpr double kTurnStep = 0.025, kApproachSteps = 24;
  const int turns = static_cast<int>(params.turn_max / kTurnStep);
  std::vector<Motion> motions;
  for (int before = -turns; before <= turns; ++before) {
    for (int now = -turns; now <= turns; ++now) {
      for (int step = 0; step <= kApproachSteps; ++step) {
        const double share = step / kApproachSteps;
        motions.push_back({before * kTurnStep, now * kTurnStep, params.approach_max * share * share});
      }
    }
  }
  return motions;
}

/// How much more than standing still a motion must explain.
double price_of(const Motion& motion, const LineFollowerParams& params) {
  constexpr double kPrice = 0.3;
  const double approach_share = motion.approach / std::max(params.approach_max, 1e-9);
  const double turn_share = std::abs(motion.end_now - motion.end_before) / std::max(params.turn_max, 1e-9);
  return kPrice * (std::sqrt(approach_share) + turn_share);
}

Pairing Comparison::best_pairing(const std::vector<Motion>& motions) {
  Motion chosen;
  double worth = compare(chosen);
  for (const Motion& motion : motions) {
    const double its_worth = compare(motion) - price_of(motion, params_);
    if (its_worth <= worth) continue;
    worth = its_worth;
    chosen = motion;
  }
  return {worth, pairs(chosen)};
}

}  // namespace

void LineFollowerParams::describe(FieldList& fields) {
  fields.real("gate", gate, {0.001, 1},
              "how far from where it is expected a line may be, share of the width");
  fields.real("turn_max", turn_max, {0, 0.5}, "how far the corridor's end may be from the image's middle");
  fields.real("approach_max", approach_max, {0, 100},
              "forward motion between two images: x goes to x / (1 - it x)");
  fields.real("slope_gate", slope_gate, {0.001, 10}, "change of a line's slope");
  fields.real("tone_gate", tone_gate, {0.1, 255}, "change of the grey level beside a line");
  fields.real("likeness_min", likeness_min, {0, 1000},
              "of all lines together, at best 1 each, less for great motion; below: none");
}

std::vector<LineLook> line_looks(const Image& grey, const std::vector<VerticalLine>& lines) {
  std::vector<LineLook> looks;
  looks.reserve(lines.size());
  for (const VerticalLine& line : lines) looks.push_back(look_of(grey, line));
  return looks;
}

double lines_likeness(const std::vector<LineLook>& a, const std::vector<LineLook>& b,
                      const LineFollowerParams& params) {
  constexpr double kBeforehand = 1;  // lines supposed to be alike: few lines say little
  const std::vector<Motion> motions = possible_motions(params);
  const double worth = std::max(Comparison(a, b, params).best_pairing(motions).worth,
                                Comparison(b, a, params).best_pairing(motions).worth);
  return (worth + kBeforehand) / (static_cast<double>(a.size() + b.size()) / 2 + kBeforehand);
}

std::vector<int> LineFollower::follow(const Image& grey, const std::vector<VerticalLine>& lines) {
  std::vector<LineLook> looks = line_looks(grey, lines);
  std::vector<int> numbers(lines.size(), -1);
  const Pairing pairing = Comparison(looks_, looks, params_).best_pairing(possible_motions(params_));
  if (pairing.worth >= params_.likeness_min) {
    for (const auto& [before, now] : pairing.pairs) numbers[now] = numbers_[before];
  }
  for (int& number : numbers) {
    if (number < 0) number = next_number_++;
  }
  looks_ = std::move(looks);
  numbers_ = numbers;
  return numbers;
}

}  // namespace aisle
