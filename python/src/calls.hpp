#pragma once
/// How calls from Python run: without the interpreter's lock, interrupted by Ctrl-C, their problems as
/// exceptions.

#include <pybind11/pybind11.h>

#include <chrono>
#include <filesystem>
#include <utility>

#include "aisle/commands/outcome.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"

namespace aisle::python {

namespace py = pybind11;

/// Raises OSError if `path` cannot be read, else aisle.InputError, with the words that the program says.
[[noreturn]] void raise_problems(const Problems& problems, const std::filesystem::path& path = {});

/// The value, or its problems as an exception.
template <class Value>
Value value_or_raise(Result<Value> result, const std::filesystem::path& path = {}) {
  if (!result) raise_problems(result.problems(), path);
  return std::move(result).value();
}

/// [aisle.Problem]
py::list list_of(const Problems& problems);

/// Lets other threads of Python run while `work` does.
template <class Work>
auto without_lock(Work work) {
  const py::gil_scoped_release release;
  return work();
}

/// Looks for Ctrl-C and calls the user's function `(task, done, total)`, some twenty times a second. Either
/// may end the work: with the exception that it raised.
class PythonProgress final : public Progress {
 public:
  /// @param callback  None: only Ctrl-C is looked for
  explicit PythonProgress(py::object callback) : callback_(std::move(callback)) {}

  void report(std::string_view task, std::size_t done, std::size_t total) override;

 private:
  py::object callback_;
  std::chrono::steady_clock::time_point next_ = {};
};

/// A verb's environment: warnings come with the results.
class PythonConsole {
 public:
  explicit PythonConsole(py::object callback) : progress_(std::move(callback)) {}

  Console& operator*() { return console_; }
  Progress& progress() { return progress_; }

 private:
  PythonProgress progress_;
  Console console_{progress_, [](const std::string&) {}};
};

/// Parameters by their keys, as texts: {"loops.submap_m": "4"}. None: none.
/// @throws py::type_error unless keys are texts and values numbers, flags or texts
std::vector<std::pair<std::string, std::string>> parameter_texts(const py::object& parameters);

/// Assigns parameters to a struct with `describe`. Raises all problems at once.
template <class Params>
Params params_from(const py::object& parameters) {
  Params params;
  FieldList fields = fields_of(params);
  Problems problems;
  for (const auto& [key, value] : parameter_texts(parameters))
    for (Problem& problem : fields.assign(key, value, {"parameters"})) problems.push_back(std::move(problem));
  if (!problems.empty()) raise_problems(problems);
  return params;
}

}  // namespace aisle::python
