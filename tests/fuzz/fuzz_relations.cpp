#include "aisle/formats/logs/relations.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  LaserLog log;
  for (const double stamp_s : {1211.520329, 1215.570657, 3.5}) {
    log.scans.emplace_back();
    log.scans.back().stamp_s = stamp_s;
  }
  const auto relations = parse_relations(fuzz_text(bytes, size), "input", log);
  if (!relations.ok()) return 0;
  for (const PoseRelation& relation : *relations) {
    require(relation.scan_1 < log.scans.size() && relation.scan_2 < log.scans.size());
    require(relation.T_1_2.is_finite());
  }
  return 0;
}
