#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>

#include "aisle/formats/calibration_file.hpp"
#include "aisle/formats/images/image_file.hpp"
#include "aisle/vision/floor/line_finder.hpp"
#include "aisle/vision/route/route_region.hpp"
#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"

namespace aisle::python {
namespace {

/// Free-space segmentation by the keys that `aisle detect region` knows.
struct FloorParams {
  RegionParams region;

  void describe(FieldList& fields) { fields.group("region", region); }
};

std::optional<CameraModel> camera_from(const std::optional<std::filesystem::path>& file) {
  if (!file) return std::nullopt;
  return CameraModel(value_or_raise(read_calibration(*file), *file).intrinsics);
}

std::unique_ptr<LineFinder> make_line_finder(const py::object& parameters,
                                             const std::optional<std::filesystem::path>& camera) {
  return std::make_unique<LineFinder>(params_from<LineFinderParams>(parameters), camera_from(camera));
}

FoundLines find_lines(LineFinder& finder, const py::array& pixels) {
  const Image image = image_of(pixels);
  return finder.find(image);
}

py::array ends_of(const FoundLines& lines) {
  py::array_t<double> ends({py::ssize_t(lines.verticals.size()), py::ssize_t(4)});
  double* number = ends.mutable_data();
  for (const VerticalLine& line : lines.verticals) {
    for (const Vec2& end : {line.top_px, line.bottom_px}) {
      *number++ = end.x();
      *number++ = end.y();
    }
  }
  return ends;
}

template <class Points>
py::object array_or_none(const std::optional<Points>& points) {
  return points ? py::object(array_of(*points)) : py::none();
}

py::array find_floor(const py::array& pixels, const py::object& parameters) {
  const RegionParams params = params_from<FloorParams>(parameters).region;
  const Image image = image_of(pixels);
  Image mask = without_lock([&] { return find_route_region(image, params).mask; });
  const py::ssize_t height = mask.height_px, width = mask.width_px;
  return moved_to_array(std::move(mask.bytes), {height, width});
}

py::array read_pixels(const std::filesystem::path& path) {
  Image image = value_or_raise(without_lock([&] { return read_image(path); }), path);
  std::vector<py::ssize_t> shape = {image.height_px, image.width_px};
  if (image.channels > 1) shape.push_back(image.channels);
  return moved_to_array(std::move(image.bytes), std::move(shape));
}

}  // namespace

void bind_detection(py::module_& module) {
  py::class_<FoundLines>(
      module, "Lines",
      "Vertical lines and wall-floor edges of one image, in pixels of the image as given: (u, v), u right, "
      "v down, (0, 0) the CENTRE of the top-left pixel.")
      .def_property_readonly("verticals", ends_of,
                             "(lines, 4), a copy: top u, v and bottom u, v, from left to right.")
      .def_property_readonly(
          "contrasts",
          [](const py::object& self) {
            return column_of(self.cast<const FoundLines&>().verticals, &VerticalLine::contrast, self);
          },
          "(lines,): mean step across each [grey levels]; positive: the right side is brighter.")
      .def_property_readonly(
          "has_floor_point",
          [](const py::object& self) {
            return column_of(self.cast<const FoundLines&>().verticals, &VerticalLine::has_floor_point, self);
          },
          "(lines,) bool: the lower end stands on a wall-floor edge.")
      .def_property_readonly(
          "left_base_line", [](const FoundLines& lines) { return array_or_none(lines.base_lines.left); },
          "(points, 2) of the wall-floor edge on the left, from far to near, or None.")
      .def_property_readonly(
          "right_base_line", [](const FoundLines& lines) { return array_or_none(lines.base_lines.right); },
          "The same on the right.")
      .def_property_readonly(
          "vanishing_point_px",
          [](const FoundLines& lines) { return array_or_none(lines.base_lines.vanishing_point_px); },
          "(2,) of the corridor, or None.");
  py::class_<LineFinder>(
      module, "LineFinder",
      "Finds vertical lines and wall-floor edges. Keep one for the images of a camera: its memory is "
      "used again. One thread at a time.")
      .def(py::init(&make_line_finder), py::arg("parameters") = py::none(), py::kw_only(),
           py::arg("camera") = py::none(),
           "parameters: {key: value} of `aisle detect baselines --print-params`.\n"
           "camera: calibration file; lines are fitted where the lens's distortion is undone.")
      .def("find", find_lines, py::arg("image"),
           "image: (height, width) grey or (height, width, 3) RGB, uint8.");
  module.def(
      "detect_floor", find_floor, py::arg("image"), py::kw_only(), py::arg("parameters") = py::none(),
      "(height, width) uint8: 255 on the floor that a vehicle can drive on, one connected region, else 0.\n\n"
      "image: (height, width) grey or (height, width, 3) RGB, uint8; colour helps.\n"
      "parameters: {key: value} of `aisle detect region --print-params`, those of 'region'.");
  module.def("read_image", read_pixels, py::arg("path"),
             "(height, width) grey or (height, width, 3) RGB, uint8, of a PNG, JPEG, PNM, BMP or TIFF file.");
}

}  // namespace aisle::python
