#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>

#include "aisle/formats/archive.hpp"
#include "aisle/formats/sessions/session_cycles.hpp"
#include "bindings.hpp"
#include "calls.hpp"

namespace aisle::python {
namespace {

/// A recorded mission, cycle by cycle; an archive stays unpacked as long as it is read.
struct Session {
  std::filesystem::path path;
  std::optional<UnpackedArchive> archive;
  SessionCycles cycles;
};

std::unique_ptr<Session> open(const std::filesystem::path& path, const py::object& progress) {
  PythonProgress reporting(progress);
  std::optional<UnpackedArchive> archive;
  if (is_archive(path))
    archive = value_or_raise(without_lock([&] { return UnpackedArchive::open(path, reporting); }), path);
  const std::filesystem::path folder = archive ? archive->root() : path;
  auto cycles = value_or_raise(without_lock([&] { return SessionCycles::open(folder); }), path);
  return std::make_unique<Session>(Session{path, std::move(archive), std::move(cycles)});
}

py::tuple next_of(Session& session) {
  auto cycle = value_or_raise(without_lock([&] { return session.cycles.next(); }), session.path);
  if (!cycle) throw py::stop_iteration();
  return py::make_tuple(std::make_shared<Observation>(std::move(cycle->observation)), cycle->decision);
}

}  // namespace

void bind_sessions(py::module_& module) {
  py::class_<Session>(
      module, "Session",
      "A recorded mission: an iterator over its cycles, each an (Observation, Decision or None). What the "
      "simulator knew besides is not in it.")
      .def("__iter__", [](py::object self) { return self; })
      .def("__next__", next_of)
      .def_property_readonly(
          "vehicle", [](const Session& session) { return session.cycles.vehicle(); }, "Vehicle that drove.")
      .def_property_readonly(
          "navigator", [](const Session& session) { return session.cycles.origin().navigator; },
          "Name of what decided.")
      .def_property_readonly(
          "parameters", [](const Session& session) { return session.cycles.origin().parameters; },
          "{key: value} of the navigator, where they differ from the defaults.")
      .def_property_readonly("seed", [](const Session& session) { return session.cycles.origin().seed; })
      .def_property_readonly("is_simulated",
                             [](const Session& session) { return session.cycles.origin().simulated; });
  module.def("read_session", open, py::arg("path"), py::kw_only(), py::arg("progress") = py::none(),
             "Opens a session, also in an archive. Raises OSError or InputError.");
}

}  // namespace aisle::python
