#include "grid.hpp"

#include "arrays.hpp"

namespace aisle::python {
namespace {

std::uint8_t value_of(Floor floor) {
  switch (floor) {
    case Floor::kFree:
      return kCellFree;
    case Floor::kOccupied:
      return kCellOccupied;
    case Floor::kUnknown:
      break;
  }
  return kCellUnknown;
}

}  // namespace

OccupancyImage image_of(const FloorGrid& floor) {
  const FloorBox& known = floor.known();
  OccupancyImage image{.width = known.end.x - known.low.x,
                       .height = known.end.y - known.low.y,
                       .resolution_m = floor.cell_m(),
                       .origin_m = floor.cell_m() * Vec2(known.low.x, known.low.y)};
  image.cells.reserve(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  for (int y = known.end.y - 1; y >= known.low.y; --y)
    for (int x = known.low.x; x < known.end.x; ++x)
      image.cells.push_back(value_of(floor.at(FloorCell{x, y})));
  return image;
}

void bind_grid(py::module_& module) {
  py::class_<OccupancyImage>(module, "Grid", "Floor as an image of square cells, as ROS's map_server has it.")
      .def_property_readonly(
          "cells",
          [](const py::object& self) {
            const auto& image = self.cast<const OccupancyImage&>();
            return view_of(image.cells.data(), {image.height, image.width}, {image.width, 1}, self);
          },
          "(rows, columns) uint8, read-only, not copied: 0 occupied, 254 free, 205 unknown. Row 0 is the TOP "
          "row, of "
          "the greatest y.")
      .def_readonly("resolution_m", &OccupancyImage::resolution_m, "Side of a cell.")
      .def_property_readonly(
          "origin_m", [](const OccupancyImage& image) { return array_of(image.origin_m); },
          "(2,): x, y in `map` of the lower left corner of the lower left cell, which is cells[-1, 0].");
}

}  // namespace aisle::python
