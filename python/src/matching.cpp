#include <cmath>

#include "aisle/matching/point_alignment.hpp"
#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"

namespace aisle::python {
namespace {

constexpr double kReachMax_m = 5;

std::vector<SurfacePoint> surface_of(const py::object& points, const char* name) {
  std::vector<SurfacePoint> surface;
  surface_points(points_of_array(points, name), surface);
  if (surface.empty())
    raise_problems(
        {{{name}, "shows no surface: needs points of a wall, in the order of the beams, not one by one"}});
  return surface;
}

SearchReach reach_from(double reach_m, double reach_rad) {
  if (!(reach_m >= 0 && reach_m <= kReachMax_m)) raise_problems({{{"reach_m"}, "is not from 0 to 5"}});
  if (!(reach_rad >= 0 && reach_rad <= kPi)) raise_problems({{{"reach_rad"}, "is not from 0 to pi"}});
  return {reach_m, reach_rad};
}

SurfaceFit match(const py::object& reference_points, const py::object& points, const py::object& guess,
                 double reach_m, double reach_rad) {
  const std::vector<SurfacePoint> reference = surface_of(reference_points, "reference_points");
  const std::vector<SurfacePoint> surface = surface_of(points, "points");
  const Pose2 T_reference_guess = pose_of(guess, "guess");
  const SearchReach reach = reach_from(reach_m, reach_rad);
  return without_lock([&] {
    SurfaceMap map;
    map.add(reference, {});
    if (reach_m == 0 && reach_rad == 0) return fit_surface(surface, map, T_reference_guess, Mat3::Zero());
    return fit_surface_far(surface, map, T_reference_guess, reach);
  });
}

}  // namespace

void bind_matching(py::module_& module) {
  py::class_<SurfaceFit>(module, "Match", "How a scan fits another, and how far to believe it.")
      .def_property_readonly(
          "pose", [](const SurfaceFit& fit) { return array_of(fit.T_map_sensor); },
          "(3,): x_m, y_m, heading_rad of the scanner, seen from where it took the reference.")
      .def_readonly("share", &SurfaceFit::share,
                    "Of the points that lie on a surface of the reference, 0 to 1.")
      .def_property_readonly(
          "information", [](const SurfaceFit& fit) { return array_of(fit.information); },
          "(3, 3): inverse covariance of the pose by the points alone; singular along a bare corridor.");
  module.def("match_scans", match, py::arg("reference_points"), py::arg("points"),
             py::arg("guess") = py::make_tuple(0, 0, 0), py::kw_only(),
             py::arg("reach_m") = SearchReach{}.position_m, py::arg("reach_rad") = SearchReach{}.heading_rad,
             "Fits a scan to another, point to line: where was the scanner when it took `points`?\n\n"
             "reference_points, points: (points, 2) x, y [m], each in the laser's frame when they were "
             "taken, in the\n"
             "order of the beams, as Scan.points_m() gives them.\n"
             "guess: (x_m, y_m, heading_rad) around which is searched.\n"
             "reach_m, reach_rad: how far to every side, up to 5 m and pi; both 0: the guess is near.\n"
             "Raises InputError where a scan shows no surface. Look at Match.share before you believe it.");
}

}  // namespace aisle::python
