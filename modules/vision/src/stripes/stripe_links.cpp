#include "stripes/stripe_links.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr double kStep_px = 1.5;      // a stripe's row may jump by this, pixel noise and speckle included
constexpr double kSlopeMemory = 0.8;  // of the slope that predicts the next row

struct Track {
  PeakChain chain;
  double slope = 0;

  double predicted_row(int column) const { return chain.back().row + slope * (column - chain.back().column); }

  void append(const StripePeak& peak, double slope_max) {
    const double seen = (peak.row - chain.back().row) / (peak.column - chain.back().column);
    slope = std::clamp(kSlopeMemory * slope + (1 - kSlopeMemory) * seen, -slope_max, slope_max);
    chain.push_back(peak);
  }
};

/// A track that a peak may continue.
struct Link {
  double distance = 0;
  std::size_t track = 0;
  std::size_t peak = 0;
};

std::vector<Link> possible_links(const std::vector<Track>& tracks, std::span<const StripePeak> column) {
  std::vector<Link> links;
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    const double row = tracks[t].predicted_row(column.front().column);
    for (std::size_t p = 0; p < column.size(); ++p) {
      const double distance = std::abs(column[p].row - row);
      if (distance <= kStep_px) links.push_back({distance, t, p});
    }
  }
  std::sort(links.begin(), links.end(), [](const Link& a, const Link& b) { return a.distance < b.distance; });
  return links;
}

/// Continues tracks by the peaks of one column, nearest first; the peaks that are left start tracks.
void extend(std::vector<Track>& tracks, std::span<const StripePeak> column, double slope_max) {
  std::vector<char> is_taken(column.size(), 0);
  for (const Link& link : possible_links(tracks, column)) {
    Track& track = tracks[link.track];
    if (is_taken[link.peak] != 0 || track.chain.back().column == column.front().column) continue;
    track.append(column[link.peak], slope_max);
    is_taken[link.peak] = 1;
  }
  for (std::size_t p = 0; p < column.size(); ++p)
    if (is_taken[p] == 0) tracks.push_back({{column[p]}, 0});
}

}  // namespace

std::vector<PeakChain> link_stripe_peaks(std::span<const StripePeak> peaks, const LinkLimits& limits) {
  std::vector<PeakChain> chains;
  std::vector<Track> tracks;
  for (std::size_t first = 0; first < peaks.size();) {
    const int column = peaks[first].column;
    std::size_t end = first;
    while (end < peaks.size() && peaks[end].column == column) ++end;
    const auto lost = std::stable_partition(tracks.begin(), tracks.end(), [&](const Track& track) {
      return column - track.chain.back().column <= limits.gap_max_px + 1;
    });
    for (auto track = lost; track != tracks.end(); ++track) chains.push_back(std::move(track->chain));
    tracks.erase(lost, tracks.end());
    extend(tracks, peaks.subspan(first, end - first), limits.slope_max);
    first = end;
  }
  for (Track& track : tracks) chains.push_back(std::move(track.chain));
  return chains;
}

}  // namespace aisle
