#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/learning/sections/section_learning.hpp"

namespace aisle {
namespace {

constexpr double kTurnAlike_rad = 3 * kTurnQuantum_rad;
constexpr double kLengthAlike_m = 0.5, kLengthAlike = 0.1;

/// The median; of an even number, the mean of the two in the middle.
double middle_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

bool is_alike(const Section& a, const Section& b) {
  const double length_alike_m = std::max(kLengthAlike_m, kLengthAlike * std::max(a.length_m, b.length_m));
  return a.kind == b.kind && std::abs(a.turn_rad - b.turn_rad) < kTurnAlike_rad &&
         std::abs(a.length_m - b.length_m) < length_alike_m;
}

bool is_alike(const DrivenList& a, const DrivenList& b) {
  return std::equal(a.sections.begin(), a.sections.end(), b.sections.begin(), b.sections.end(),
                    [](const Section& one, const Section& other) { return is_alike(one, other); });
}

/// The largest group of similar drives.
std::vector<std::size_t> most_alike(std::span<const DrivenList> drives) {
  std::vector<std::size_t> most;
  for (const DrivenList& form : drives) {
    std::vector<std::size_t> alike;
    for (std::size_t i = 0; i < drives.size(); ++i) {
      if (is_alike(form, drives[i])) alike.push_back(i);
    }
    if (alike.size() > most.size()) most = std::move(alike);
  }
  return most;
}

/// The median of a value over the drives that have it; nullopt if none does.
template <typename Tell>
std::optional<double> median_over(const std::vector<DrivenList>& drives, Tell&& tell) {
  std::vector<double> values;
  for (const DrivenList& drive : drives) {
    if (const std::optional<double> value = tell(drive)) values.push_back(*value);
  }
  if (values.empty()) return std::nullopt;
  return middle_of(std::move(values));
}

Section merged_section(const std::vector<DrivenList>& drives, std::size_t i) {
  const auto middle = [&](auto Section::*member) {
    return median_over(
        drives, [&](const DrivenList& drive) -> std::optional<double> { return drive.sections[i].*member; });
  };
  Section section = drives.front().sections[i];
  section.length_m = *middle(&Section::length_m);
  section.turn_rad = std::round(*middle(&Section::turn_rad) / kTurnQuantum_rad) * kTurnQuantum_rad;
  section.right_m = middle(&Section::right_m);
  section.left_m = middle(&Section::left_m);
  section.ahead_m = middle(&Section::ahead_m);
  return section;
}

}  // namespace

MergedDrives merge_drives(std::span<const DrivenList> drives) {
  std::vector<std::size_t> taken = most_alike(drives);
  std::vector<DrivenList> alike;
  alike.reserve(taken.size());
  for (const std::size_t i : taken) alike.push_back(drives[i]);
  MergedDrives merged{.driven = alike.front(), .taken = std::move(taken)};
  for (std::size_t i = 0; i < merged.driven.sections.size(); ++i)
    merged.driven.sections[i] = merged_section(alike, i);
  merged.driven.unseen = std::min_element(alike.begin(), alike.end(), [](const auto& a, const auto& b) {
                           return a.unseen.length_m < b.unseen.length_m;
                         })->unseen;
  merged.driven.corridor_width_m =
      median_over(alike, [](const DrivenList& drive) { return drive.corridor_width_m; });
  return merged;
}

}  // namespace aisle
