#include "arrays.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace aisle::python {
namespace {

constexpr py::ssize_t kImageSideMax = 16384;
constexpr py::ssize_t kPointsMax = 1'000'000;
constexpr double kFarthest = 1e5;  // beyond 100 km is no building

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

[[noreturn]] void refuse_image(const py::array& pixels) {
  throw py::value_error(fmt::format(
      "image: is {} of {}; needs (height, width) or (height, width, 3) of uint8, 1 to {} pixels a side",
      py::str(py::tuple(pixels.attr("shape"))).cast<std::string>(),
      py::str(pixels.dtype()).cast<std::string>(), kImageSideMax));
}

bool is_image(const py::array& pixels) {
  const auto is_side = [&](int axis) {
    return pixels.shape(axis) >= 1 && pixels.shape(axis) <= kImageSideMax;
  };
  if (!pixels.dtype().equal(py::dtype::of<std::uint8_t>())) return false;
  if (pixels.ndim() != 2 && !(pixels.ndim() == 3 && pixels.shape(2) == 3)) return false;
  return is_side(0) && is_side(1);
}

Doubles doubles_of(const py::object& numbers, const std::string& refusal) {
  Doubles doubles = Doubles::ensure(numbers);
  if (!doubles) throw py::value_error(refusal);
  const bool are_sound = std::all_of(doubles.data(), doubles.data() + doubles.size(),
                                     [](double number) { return std::abs(number) <= kFarthest; });
  if (!are_sound) throw py::value_error(refusal);
  return doubles;
}

}  // namespace

py::array array_of(const Vec2& point) {
  return py::array_t<double>(2, point.data());
}

py::array array_of(const Pose2& pose) {
  return py::array_t<double>(3, &pose.x);
}

py::array array_of(const Mat3& matrix) {
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = matrix;
  return py::array_t<double>({3, 3}, rows.data());
}

py::array array_of(const std::vector<Vec2>& points) {
  py::array_t<double> array({py::ssize_t(points.size()), py::ssize_t(2)});
  std::copy_n(static_cast<const double*>(static_cast<const void*>(points.data())), 2 * points.size(),
              array.mutable_data());
  return array;
}

py::array array_of(std::shared_ptr<const Image> image) {
  const Image& shown = *image;
  std::vector<py::ssize_t> shape = {shown.height_px, shown.width_px};
  std::vector<py::ssize_t> strides = {py::ssize_t(shown.row_bytes()), shown.channels};
  if (shown.channels > 1) {
    shape.push_back(shown.channels);
    strides.push_back(1);
  }
  const py::capsule owner(new std::shared_ptr<const Image>(std::move(image)),
                          [](void* kept) { delete static_cast<std::shared_ptr<const Image>*>(kept); });
  return view_of(shown.bytes.data(), std::move(shape), std::move(strides), owner);
}

Image image_of(const py::array& pixels) {
  if (!is_image(pixels)) refuse_image(pixels);
  const auto packed = py::array_t<std::uint8_t, py::array::c_style>::ensure(pixels);
  Image image(static_cast<int>(packed.shape(1)), static_cast<int>(packed.shape(0)),
              packed.ndim() == 3 ? 3 : 1);
  std::copy_n(packed.data(), packed.size(), image.bytes.data());
  return image;
}

Pose2 pose_of(const py::object& numbers, const char* name) {
  const std::string refusal =
      fmt::format("{}: needs three numbers up to 100000: x_m, y_m, heading_rad", name);
  const Doubles pose = doubles_of(numbers, refusal);
  if (pose.ndim() != 1 || pose.shape(0) != 3) throw py::value_error(refusal);
  return {pose.at(0), pose.at(1), pose.at(2)};
}

std::vector<Vec2> points_of_array(const py::object& numbers, const char* name) {
  const std::string refusal = fmt::format(
      "{}: needs a (points, 2) array of numbers up to 100000, at most {} points", name, kPointsMax);
  const Doubles rows = doubles_of(numbers, refusal);
  if (rows.ndim() != 2 || rows.shape(1) != 2 || rows.shape(0) > kPointsMax) throw py::value_error(refusal);
  std::vector<Vec2> points(static_cast<std::size_t>(rows.shape(0)));
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = {rows.data()[2 * i], rows.data()[2 * i + 1]};
  return points;
}

}  // namespace aisle::python
