#include "aisle/learning/walls/model_updating.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace aisle {
namespace {

bool coincide(const OrthogonalSegment& a, const OrthogonalSegment& b, const ModelUpdateParams& params) {
  return std::abs(a.extent.min - b.extent.min) < params.end_m &&
         std::abs(a.extent.max - b.extent.max) < params.end_m;
}

bool belong_together(const OrthogonalSegment& a, const OrthogonalSegment& b,
                     const ModelUpdateParams& params) {
  return a.along_x == b.along_x && std::abs(a.coordinate_m - b.coordinate_m) < params.across_m &&
         (a.extent.overlap(b.extent) > 0 || coincide(a, b, params));
}

/// Numbers the groups of segments that belong together, directly or through others.
std::vector<std::size_t> groups_of(const std::vector<OrthogonalSegment>& segments,
                                   const ModelUpdateParams& params) {
  std::vector<std::size_t> parent(segments.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t j = i + 1; j < segments.size(); ++j) {
      if (!belong_together(segments[i], segments[j], params)) continue;
      const std::size_t a = root(i), b = root(j);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  for (std::size_t i = 0; i < segments.size(); ++i) parent[i] = root(i);
  return parent;
}

OrthogonalSegment united(const std::vector<OrthogonalSegment>& group, const ModelUpdateParams& params) {
  OrthogonalSegment whole = group.front();
  const auto count = static_cast<double>(group.size());
  Interval mean;
  whole.coordinate_m = 0;
  for (const OrthogonalSegment& s : group) {
    whole.coordinate_m += s.coordinate_m / count;
    whole.extent = whole.extent.united(s.extent);
    mean.min += s.extent.min / count;
    mean.max += s.extent.max / count;
  }
  const bool all_coincide = std::all_of(group.begin(), group.end(), [&](const OrthogonalSegment& a) {
    return std::all_of(group.begin(), group.end(),
                       [&](const OrthogonalSegment& b) { return coincide(a, b, params); });
  });
  if (all_coincide) whole.extent = mean;
  whole.min_occurrences = whole.max_occurrences = 0;
  for (const OrthogonalSegment& s : group) {
    if (std::abs(s.extent.min - whole.extent.min) < params.end_m) {
      whole.min_occurrences = std::max(whole.min_occurrences, s.min_occurrences);
    }
    if (std::abs(s.extent.max - whole.extent.max) < params.end_m) {
      whole.max_occurrences = std::max(whole.max_occurrences, s.max_occurrences);
    }
  }
  return whole;
}

/// Step 6: counts end points of the model near an end point of the view as seen once more.
void count_occurrences(std::span<const OrthogonalSegment> view, const ModelUpdateParams& params,
                       OrthogonalSegment& segment) {
  for (const OrthogonalSegment& s : view) {
    if (s.along_x != segment.along_x || std::abs(s.coordinate_m - segment.coordinate_m) > params.across_m)
      continue;
    if (std::abs(s.extent.min - segment.extent.min) < params.end_m) ++segment.min_occurrences;
    if (std::abs(s.extent.max - segment.extent.max) < params.end_m) ++segment.max_occurrences;
  }
}

}  // namespace

Segment2 OrthogonalSegment::segment() const {
  if (along_x) return {{extent.min, coordinate_m}, {extent.max, coordinate_m}};
  return {{coordinate_m, extent.min}, {coordinate_m, extent.max}};
}

std::vector<OrthogonalSegment> update_model(std::span<const OrthogonalSegment> model,
                                            std::span<const OrthogonalSegment> view,
                                            const ModelUpdateParams& params) {
  std::vector<OrthogonalSegment> all(model.begin(), model.end());
  all.insert(all.end(), view.begin(), view.end());
  const std::vector<std::size_t> group_of = groups_of(all, params);
  std::vector<OrthogonalSegment> updated, group;
  for (std::size_t leader = 0; leader < all.size(); ++leader) {
    if (group_of[leader] != leader) continue;
    group.clear();
    for (std::size_t i = leader; i < all.size(); ++i) {
      if (group_of[i] == leader) group.push_back(all[i]);
    }
    updated.push_back(united(group, params));
    count_occurrences(view, params, updated.back());
  }
  return updated;
}

}  // namespace aisle
