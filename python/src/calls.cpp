#include "calls.hpp"

#include <unistd.h>

#include <cerrno>

namespace aisle::python {
namespace {

constexpr std::chrono::milliseconds kReportEvery(50);

py::object failure_class(const char* name) {
  return py::module_::import("aisle._failures").attr(name);
}

}  // namespace

py::list list_of(const Problems& problems) {
  const py::object problem_class = failure_class("Problem");
  py::list list;
  for (const Problem& problem : problems) list.append(problem_class(to_string(problem.where), problem.what));
  return list;
}

void raise_problems(const Problems& problems, const std::filesystem::path& path) {
  if (!path.empty() && ::access(path.c_str(), R_OK) != 0) {
    const int reason = errno;
    const py::tuple arguments = py::make_tuple(reason, problems.front().what, path.string());
    PyErr_SetObject(PyExc_OSError, arguments.ptr());
  } else {
    const py::object input_error = failure_class("InputError");
    PyErr_SetObject(input_error.ptr(), input_error(list_of(problems)).ptr());
  }
  throw py::error_already_set();
}

void PythonProgress::report(std::string_view task, std::size_t done, std::size_t total) {
  const auto now = std::chrono::steady_clock::now();
  if (now < next_ && (total == 0 || done < total)) return;
  next_ = now + kReportEvery;
  const py::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (!callback_.is_none()) callback_(task, done, total);
}

std::vector<std::pair<std::string, std::string>> parameter_texts(const py::object& parameters) {
  std::vector<std::pair<std::string, std::string>> texts;
  if (parameters.is_none()) return texts;
  for (const auto& [key, value] : py::dict(parameters)) {
    if (!py::isinstance<py::str>(key)) throw py::type_error("parameters: keys are texts");
    const std::string text = py::isinstance<py::bool_>(value) ? (value.cast<bool>() ? "true" : "false")
                                                              : py::str(value).cast<std::string>();
    texts.emplace_back(key.cast<std::string>(), text);
  }
  return texts;
}

}  // namespace aisle::python
