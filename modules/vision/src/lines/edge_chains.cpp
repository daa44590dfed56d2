#include "lines/edge_chains.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {

namespace {

constexpr int kCountMin = 4;       // points of a chain
constexpr int kMemory = 14;        // points that the prediction remembers
constexpr int kMissedMax = 2;      // bands without a step that a chain survives ...
constexpr int kMissedMaxLong = 4;  // ... and one of more points
constexpr int kLongCount = 6;
constexpr float kChainContrastRatioMax = 4;  // between a chain and a step that it takes
constexpr float kPixelsPerRatio = 0.25F;     // how much nearer an edge of twice the contrast has to be

/// How much of a residual goes to position and slope at the n-th point: an expanding least-squares fit until
/// the memory is full.
struct Gains {
  float position = 0, slope = 0;
};
Gains gains(int n) {
  const auto m = static_cast<float>(std::min(n, kMemory));
  return {2 * (2 * m - 1) / (m * (m + 1)), 6 / (m * (m + 1))};
}

float ratio(float a, float b) {
  return a > b ? a / b : b / a;
}

}  // namespace

void EdgeLinker::link(const Image& grey, const LinkParams& params) {
  params_ = params;
  growing_.clear();
  links_.clear();
  chains_.clear();
  points_.clear();
  for (int row = 0; row + params.band_rows <= grey.height_px; row += params.band_rows) {
    band_.find(grey, row, params.band_rows, static_cast<float>(params.contrast_min));
    grow(band_);
  }
  for (const Growing& chain : growing_) finish(chain);
}

void EdgeLinker::grow(const EdgeBand& band) {
  for (const Step step : kBothSteps)
    taken_[static_cast<std::size_t>(step)].assign(band.edges(step).size(), 0);
  std::size_t kept = 0;
  for (Growing& chain : growing_) {
    const int found = best_edge(band, chain);
    if (found >= 0) {
      taken_[static_cast<std::size_t>(chain.step)][static_cast<std::size_t>(found)] = 1;
      append(chain, band.edges(chain.step)[static_cast<std::size_t>(found)]);
    } else {
      ++chain.missed;
    }
    const int missed_max = chain.count > kLongCount ? kMissedMaxLong : kMissedMax;
    if (chain.missed <= missed_max && std::abs(chain.slope) < params_.slope_max) {
      growing_[kept++] = chain;
    } else {
      finish(chain);
    }
  }
  growing_.resize(kept);
  for (const Step step : kBothSteps) {
    const auto& edges = band.edges(step);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (!taken_[static_cast<std::size_t>(step)][i]) start(step, edges[i]);
    }
  }
}

/// The free edge nearest to the prediction, those of like contrast preferred; -1 if none is near.
int EdgeLinker::best_edge(const EdgeBand& band, const Growing& chain) const {
  const auto& edges = band.edges(chain.step);
  if (edges.empty()) return -1;
  const float u_px = chain.u_px + chain.slope * (edges.front().v_px - chain.v_px);
  const auto stray_px = static_cast<float>(
      chain.count < 3 ? std::max(params_.stray_px, params_.slope_unknown * params_.band_rows)
                      : params_.stray_px);
  const int first = std::max(0, static_cast<int>(std::floor(u_px - stray_px)));
  const int last = std::min(band.columns() - 1, static_cast<int>(std::ceil(u_px + stray_px)));
  int best = -1;
  float least = 1e9F;
  for (int column = first; column <= last; ++column) {
    const int candidate = band.edge_at(chain.step, column);
    if (candidate < 0) continue;
    const auto i = static_cast<std::size_t>(candidate);
    if (taken_[static_cast<std::size_t>(chain.step)][i]) continue;
    const float off_px = std::abs(edges[i].u_px - u_px);
    const float contrasts = ratio(edges[i].contrast, chain.contrast);
    if (off_px > stray_px || contrasts > kChainContrastRatioMax) continue;
    const float cost = off_px + kPixelsPerRatio * (contrasts - 1);
    if (cost < least) {
      least = cost;
      best = candidate;
    }
  }
  return best;
}

void EdgeLinker::append(Growing& chain, const EdgePoint& point) {
  const float down_px = point.v_px - chain.v_px;
  const float predicted_px = chain.u_px + chain.slope * down_px;
  const Gains gain = gains(++chain.count);
  chain.u_px = predicted_px + gain.position * (point.u_px - predicted_px);
  chain.slope += gain.slope * (point.u_px - predicted_px) / down_px;
  chain.v_px = point.v_px;
  chain.contrast = point.contrast;
  chain.missed = 0;
  links_.push_back({point, chain.last_link});
  chain.last_link = static_cast<int>(links_.size()) - 1;
}

void EdgeLinker::start(Step step, const EdgePoint& point) {
  links_.push_back({point, -1});
  growing_.push_back(
      {step, point.u_px, point.v_px, 0, point.contrast, 1, static_cast<int>(links_.size()) - 1, 0});
}

void EdgeLinker::finish(const Growing& chain) {
  if (chain.count < kCountMin) return;
  const auto count = static_cast<std::size_t>(chain.count);
  chains_.push_back({chain.step, points_.size(), count});
  points_.resize(points_.size() + count);
  auto out = points_.rbegin();
  for (int i = chain.last_link; i >= 0; i = links_[static_cast<std::size_t>(i)].previous) {
    *out++ = links_[static_cast<std::size_t>(i)].point;
  }
}

}  // namespace aisle
