#pragma once

#include <cstddef>
#include <span>

namespace aisle {

/// Spreads stamps that a writer rounded, such as 1134 1134 1134 1135 1135, evenly over each run of equal
/// ones. Leaves all others alone: clocks of which most stamps differ from the one before, that go back, leap
/// by more than a minute, or show fewer than three different stamps.
/// @return the first stamp that was changed; the number of stamps if none was
std::size_t spread_rounded_stamps(std::span<double> stamps_s);

}  // namespace aisle
