#pragma once

#include "aisle/core/parameters.hpp"

namespace aisle {

struct LoopParams {
  double submap_m = 2;            ///< path length of one submap: a place is recognised when one is complete
  double path_apart_m = 12;       ///< two submaps nearer along the path are no loop
  double reach_floor_m = 0.4;     ///< search radius around the expected place ...
  double reach_per_m = 0.01;      ///< ... plus this much per metre of path between the two ...
  double reach_max_m = 8;         ///< ... but no more
  double score_min = 0.5;         ///< share of the wall length that must lie on old walls
  double rival_share_max = 0.85;  ///< a different place that fits better than this share makes it ambiguous
  double sure_reach_m = 1;        ///< a larger search needs a second submap that agrees
  double agree_m = 0.3;           ///< within this distance
  double cauchy_sigmas = 3;

  void describe(FieldList& fields);
};

}  // namespace aisle
