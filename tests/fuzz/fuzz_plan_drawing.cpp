#include "aisle/formats/images/plan_drawing.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

/// DXF alone: SVG and PDF are read by librsvg and pdftocairo.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view text = fuzz_text(bytes, size);
  if (drawing_kind_of(text) != DrawingKind::kDxf) return 0;
  const auto read = parse_plan_drawing(text, "input", {.cell_m = 1});
  if (!read) require(!read.problems().empty());
  return 0;
}
