#include "calibration_lens.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace aisle {
namespace {

constexpr std::array<std::pair<std::string_view, LensModel>, 9> kModelNames = {
    {{"plumb_bob", LensModel::kPlumbBob},
     {"radtan", LensModel::kPlumbBob},
     {"none", LensModel::kPlumbBob},
     {"", LensModel::kPlumbBob},
     {"rational_polynomial", LensModel::kRationalPolynomial},
     {"equidistant", LensModel::kEquidistant},
     {"equi", LensModel::kEquidistant},
     {"fisheye", LensModel::kEquidistant},
     {"kannala_brandt", LensModel::kEquidistant}}};

std::size_t coefficients_of(LensModel model) {
  switch (model) {
    case LensModel::kPlumbBob:
      return 5;
    case LensModel::kRationalPolynomial:
      return 8;
    case LensModel::kEquidistant:
      break;
  }
  return 4;
}

}  // namespace

std::optional<LensModel> lens_model_named(std::string_view name) {
  for (const auto& [known, model] : kModelNames) {
    if (known == name) return model;
  }
  return std::nullopt;
}

const char* name_of(LensModel model) {
  switch (model) {
    case LensModel::kPlumbBob:
      return "plumb_bob";
    case LensModel::kRationalPolynomial:
      return "rational_polynomial";
    case LensModel::kEquidistant:
      break;
  }
  return "equidistant";
}

std::vector<double> distortion_coefficients(const CameraIntrinsics& c) {
  switch (c.model) {
    case LensModel::kPlumbBob:
      return {c.k1, c.k2, c.p1, c.p2, c.k3};
    case LensModel::kRationalPolynomial:
      return {c.k1, c.k2, c.p1, c.p2, c.k3, c.k4, c.k5, c.k6};
    case LensModel::kEquidistant:
      break;
  }
  return {c.k1, c.k2, c.k3, c.k4};
}

std::string set_distortion(CameraIntrinsics& lens, std::optional<LensModel> stated, std::vector<double> d) {
  const std::size_t given = d.size();
  while (d.size() > 5 && d.back() == 0) d.pop_back();
  lens.model = stated.value_or(d.size() > 5 ? LensModel::kRationalPolynomial : LensModel::kPlumbBob);
  const std::size_t needed = coefficients_of(lens.model);
  const auto is_zero = [](double v) { return v == 0; };
  if (lens.model == LensModel::kEquidistant &&
      (given < needed || !std::all_of(d.begin() + 4, d.end(), is_zero)))
    return fmt::format("has {} coefficients; the equidistant model has 4", given);
  if (d.size() > needed)
    return fmt::format("has {} coefficients; the model {} has {}", given, name_of(lens.model), needed);
  if (lens.model == LensModel::kRationalPolynomial && given < 8)
    return fmt::format("has {} coefficients; the model rational_polynomial has 8", given);
  d.resize(needed);
  if (lens.model == LensModel::kEquidistant) {
    lens.k1 = d[0], lens.k2 = d[1], lens.k3 = d[2], lens.k4 = d[3];
    return "";
  }
  lens.k1 = d[0], lens.k2 = d[1], lens.p1 = d[2], lens.p2 = d[3], lens.k3 = d[4];
  if (needed == 8) lens.k4 = d[5], lens.k5 = d[6], lens.k6 = d[7];
  const bool has_denominator = lens.k4 != 0 || lens.k5 != 0 || lens.k6 != 0;
  if (!has_denominator) lens.model = LensModel::kPlumbBob;
  return "";
}

}  // namespace aisle
