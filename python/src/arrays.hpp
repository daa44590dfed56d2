#pragma once
/// Numbers of C++ as numpy arrays: read-only views of them where they lie in memory, and the other way round.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle::python {

namespace py = pybind11;

/// A read-only array of memory that `owner` keeps alive. Nothing is copied.
template <class Number>
py::array view_of(const Number* first, std::vector<py::ssize_t> shape, std::vector<py::ssize_t> strides_bytes,
                  const py::handle& owner) {
  py::array view(py::dtype::of<Number>(), std::move(shape), std::move(strides_bytes), first, owner);
  py::detail::array_proxy(view.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return view;
}

/// (items,): one number of each item.
template <class Item, class Number>
py::array column_of(const std::vector<Item>& items, const Number Item::*number, const py::handle& owner) {
  const Number* first = items.empty() ? nullptr : &(items.front().*number);
  return view_of(first, {py::ssize_t(items.size())}, {py::ssize_t(sizeof(Item))}, owner);
}

/// (items, columns): neighbouring numbers of each item, the first of them at the start of `part`.
template <class Number, class Item, class Part>
py::array columns_of(const std::vector<Item>& items, const Part Item::*part, py::ssize_t columns,
                     const py::handle& owner) {
  const void* first = items.empty() ? nullptr : &(items.front().*part);
  return view_of(static_cast<const Number*>(first), {py::ssize_t(items.size()), columns},
                 {py::ssize_t(sizeof(Item)), py::ssize_t(sizeof(Number))}, owner);
}

/// (items, columns): items that are nothing but so many numbers.
template <class Number, class Item>
py::array rows_of(const std::vector<Item>& items, const py::handle& owner) {
  static_assert(sizeof(Item) % sizeof(Number) == 0);
  constexpr py::ssize_t kColumns = sizeof(Item) / sizeof(Number);
  return view_of(static_cast<const Number*>(static_cast<const void*>(items.data())),
                 {py::ssize_t(items.size()), kColumns},
                 {py::ssize_t(sizeof(Item)), py::ssize_t(sizeof(Number))}, owner);
}

/// An array that takes over the numbers of `values`.
template <class Number>
py::array moved_to_array(std::vector<Number> values, std::vector<py::ssize_t> shape) {
  auto* kept = new std::vector<Number>(std::move(values));
  const py::capsule owner(kept, [](void* numbers) { delete static_cast<std::vector<Number>*>(numbers); });
  return {py::dtype::of<Number>(), std::move(shape), kept->data(), owner};
}

/// (2,), (3,) and (3, 3) arrays of their own.
py::array array_of(const Vec2& point);
py::array array_of(const Pose2& pose);
py::array array_of(const Mat3& matrix);
/// (points, 2)
py::array array_of(const std::vector<Vec2>& points);

/// (height, width) or (height, width, 3), uint8: the image itself.
py::array array_of(std::shared_ptr<const Image> image);

/// A copy of a (height, width) or (height, width, 3) array of uint8. @throws py::value_error else
Image image_of(const py::array& pixels);

/// A pose from (x_m, y_m, heading_rad). @throws py::value_error unless these are three numbers of at most 1e5
Pose2 pose_of(const py::object& numbers, const char* name);

/// Points from a (points, 2) array. @throws py::value_error unless all are numbers of at most 1e5, and no
/// more than a million
std::vector<Vec2> points_of_array(const py::object& numbers, const char* name);

}  // namespace aisle::python
