#pragma once

#include "aisle/commands/outcome.hpp"
#include "aisle/trials/reproduce_options.hpp"

namespace aisle {

/// `aisle reproduce EXPERIMENT`: repeats a published experiment in simulation, beside the paper's figures.
/// - `c98`: C98 section VI. A corridor is learned, then driven five times and refined by each run. Draws C98
///   Figs. 11 and 12.
/// - `c99`: corridors are explored in C99's published order with line lasers and one camera. Draws C99
///   Figs. 5, 7 and 10.
/// - `l03`: a corridor of L03 is learned from one drive and driven there and back. Draws L03 Figs. 4 and 7.
///
/// The outcome is ok if all runs arrived without a collision.
Result<Outcome> run_reproduce(const ReproduceOptions& options, Console& console);

/// Every parameter of `aisle reproduce` with its default.
Outcome reproduce_parameters();

}  // namespace aisle
