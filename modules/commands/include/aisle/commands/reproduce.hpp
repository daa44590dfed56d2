#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"

namespace aisle {

struct ReproduceOptions {
  std::string experiment;  ///< "c98", "c99" or "l03"
  std::uint64_t seed = 1;
  std::filesystem::path out;  ///< directory for images and the learned building; empty: nothing is written
  bool force = false;
  ParameterSources parameters;
};

/// `aisle reproduce c98`: the experiment of C98 section VI in simulation. One corridor is learned, then
/// driven five times, refined by each run; what becomes of the landmarks and how well it drives, beside the
/// paper's figures. Draws C98 Figs. 11 and 12. `c99`: corridors
/// explored in C99's published order, by laser markers and one camera; draws C99 Figs. 5, 7
/// and 10. `l03`: a corridor of L03 learned from one drive and driven there and back; draws L03 Figs. 4
/// and 7. The outcome is ok if all runs arrived and touched nothing.
Result<Outcome> run_reproduce(const ReproduceOptions& options, Console& console);

/// Every parameter of `aisle reproduce` with its default.
Outcome reproduce_parameters();

}  // namespace aisle
