#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// A line of a DXF drawing, curves cut into chords, in drawing units: x right, y UP.
struct DxfLine {
  Vec2 start;
  Vec2 end;
};

struct DxfDrawing {
  std::vector<DxfLine> lines;
  std::optional<double> unit_m;        ///< by $INSUNITS
  std::map<std::string, int> skipped;  ///< entities of other kinds, by name
  int door_arcs = 0;                   ///< quarter circles: doors, not walls
};

/// Reads LINE, LWPOLYLINE, POLYLINE, ARC, CIRCLE and, with the blocks that they name, INSERT of an ASCII DXF.
Result<DxfDrawing> parse_dxf(std::string_view bytes, const std::string& name);

}  // namespace aisle
