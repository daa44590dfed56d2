#pragma once

#include <pybind11/pybind11.h>

#include "aisle/formats/images/map_server.hpp"
#include "aisle/maps/floor_grid.hpp"

namespace aisle::python {

/// The floor as an image of cells.
OccupancyImage image_of(const FloorGrid& floor);

void bind_grid(pybind11::module_& module);

}  // namespace aisle::python
