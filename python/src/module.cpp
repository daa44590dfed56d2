#include <pybind11/pybind11.h>

#include "aisle/core/progress.hpp"
#include "bindings.hpp"

PYBIND11_MODULE(_aisle, module) {
  using namespace aisle::python;
  module.doc() = "The compiled part of aisle: use the package `aisle`.";
  module.attr("__version__") = AISLE_VERSION;
  pybind11::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const aisle::Interrupted&) {
      PyErr_SetNone(PyExc_KeyboardInterrupt);
    }
  });
  bind_recordings(module);
  bind_buildings(module);
  bind_mapping(module);
  bind_vehicles(module);
  bind_sessions(module);
  bind_detection(module);
  bind_matching(module);
  bind_simulation(module);
  bind_missions(module);
}
