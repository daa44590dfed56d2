#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "aisle/geometry/sensed_segment.hpp"

namespace aisle {

/// The segments of all scans so far, in contiguous memory.
class ScanSegments {
 public:
  void append(std::span<const SensedSegment> segments) {
    all_.insert(all_.end(), segments.begin(), segments.end());
    ends_.push_back(all_.size());
  }
  std::size_t scan_count() const { return ends_.size(); }
  std::span<const SensedSegment> of_scan(std::size_t scan) const {
    const std::size_t first = scan == 0 ? 0 : ends_[scan - 1];
    return std::span(all_).subspan(first, ends_[scan] - first);
  }

 private:
  std::vector<SensedSegment> all_;
  std::vector<std::size_t> ends_;
};

}  // namespace aisle
