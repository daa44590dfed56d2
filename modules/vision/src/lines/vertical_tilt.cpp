#include "lines/vertical_tilt.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace aisle {

namespace {

constexpr std::size_t kTiltVoters = 60;     // the longest lines
constexpr std::size_t kTiltProposers = 16;  // of them, whose pairs are tried
constexpr double kTiltAgreement = 0.035;    // difference of slope at which a line's vote ends
constexpr double kAtCentreMax = 0.27;       // a camera rolled by 15 degrees
constexpr double kPerWidthMax = 0.6;        // tilted by 15 degrees, with a wide lens
constexpr double kNearShare = 0.12;         // lines nearer to each other tell nothing of the growth
constexpr double kAtCentrePrior = 0.7;      // how much a tilt must gain to be believed
constexpr double kPerWidthPrior = 0.5;

double votes(const VerticalTilt& tilt, std::span<const UprightLine> lines, int width_px) {
  double sum = 0;
  for (const UprightLine& line : lines) {
    const double off = std::abs(line.slope - tilt.slope_at(line.u_middle_px, width_px));
    sum += line.length_px() * std::max(0.0, 1 - off / kTiltAgreement);
  }
  return sum * (1 - kAtCentrePrior * std::abs(tilt.at_centre)) *
         (1 - kPerWidthPrior * std::abs(tilt.per_width));
}

/// @return nullopt if a nearly level camera cannot see two vertical lines like these
std::optional<VerticalTilt> tilt_of(const UprightLine& a, const UprightLine& b, int width_px) {
  VerticalTilt tilt;
  const double apart = (a.u_middle_px - b.u_middle_px) / width_px;
  if (std::abs(apart) > kNearShare) {
    tilt.per_width = (a.slope - b.slope) / apart;
    tilt.at_centre = a.slope - tilt.slope_at(a.u_middle_px, width_px);
  } else {
    tilt.at_centre = 0.5 * (a.slope + b.slope);
  }
  if (std::abs(tilt.at_centre) > kAtCentreMax || std::abs(tilt.per_width) > kPerWidthMax) return std::nullopt;
  return tilt;
}

}  // namespace

VerticalTilt estimate_tilt(std::span<const UprightLine> lines_longest_first, int width_px) {
  const auto voters = lines_longest_first.first(std::min(kTiltVoters, lines_longest_first.size()));
  VerticalTilt best;
  double most = votes(best, voters, width_px);
  for (std::size_t i = 0; i < std::min(kTiltProposers, voters.size()); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto tilt = tilt_of(voters[i], voters[j], width_px);
      if (!tilt) continue;
      const double sum = votes(*tilt, voters, width_px);
      if (sum > most) {
        most = sum;
        best = *tilt;
      }
    }
  }
  return best;
}

}  // namespace aisle
