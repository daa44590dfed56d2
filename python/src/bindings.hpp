#pragma once
/// The parts of the module `_aisle`, in the order in which they are bound: each may use the classes of those
/// above.

#include <pybind11/pybind11.h>

namespace aisle::python {

void bind_recordings(pybind11::module_& module);
void bind_buildings(pybind11::module_& module);
void bind_mapping(pybind11::module_& module);
void bind_vehicles(pybind11::module_& module);
void bind_sessions(pybind11::module_& module);
void bind_detection(pybind11::module_& module);
void bind_matching(pybind11::module_& module);
void bind_simulation(pybind11::module_& module);
void bind_missions(pybind11::module_& module);

}  // namespace aisle::python
