#include "aisle/formats/images/plan_image.hpp"
#include "aisle/simulation/plans/plan_tracing.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view text = fuzz_text(bytes, size);
  const bool is_netpbm = text.size() > 1 && text[0] == 'P' &&
                         (text[1] == '1' || text[1] == '2' || text[1] == '4' || text[1] == '5');
  if (!is_netpbm) return 0;  // other images are decoded by OpenCV
  auto read = parse_plan_image(text, "input", 0.05);
  if (!read.ok()) {
    require(!read.problems().empty());
    return 0;
  }
  FloorPlan* plan = &read->plan;
  require(plan->solid.size() ==
          static_cast<std::size_t>(plan->width) * static_cast<std::size_t>(plan->height));
  if (plan->solid.size() > 4000) return 0;
  SilentProgress silent;
  clean_plan(*plan, {.speck_m = 0.1});
  const auto walls = trace_plan(*plan, {}, silent);
  if (!walls) return 0;
  for (const Segment2& wall : *walls) require(wall.length() > 0);
  return 0;
}
