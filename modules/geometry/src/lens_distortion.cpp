#include "lens_distortion.hpp"

#include <cmath>
#include <initializer_list>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/core/square.hpp"

namespace aisle {
namespace {

constexpr double kWidestSlopeSquared = 100;  // 84 degrees off the axis
constexpr double kWidestAngle_rad = 89 * kDegree;
constexpr int kHalvingsMax = 100;  ///< a root at 0 has no relative precision to reach

/// Coefficients from the constant one on.
using Polynomial = std::vector<double>;

double value_at(const Polynomial& p, double q) {
  double value = 0;
  for (std::size_t i = p.size(); i-- > 0;) value = value * q + p[i];
  return value;
}

Polynomial derivative(const Polynomial& p) {
  Polynomial slope;
  for (std::size_t i = 1; i < p.size(); ++i) slope.push_back(static_cast<double>(i) * p[i]);
  return slope;
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  Polynomial product(a.size() + b.size() - 1, 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) product[i + j] += a[i] * b[j];
  }
  return product;
}

/// Where the polynomial changes its sign between 0 and `limit`, ascending.
std::vector<double> sign_changes(const Polynomial& p, double limit) {
  if (p.size() < 2) return {};
  std::vector<double> monotonic_until = sign_changes(derivative(p), limit);
  monotonic_until.push_back(limit);
  std::vector<double> found;
  double from = 0;
  for (const double until : monotonic_until) {
    double low = from, high = until;
    from = until;
    const bool is_positive = value_at(p, low) > 0;
    if (is_positive == (value_at(p, high) > 0)) continue;
    for (int halving = 0; halving < kHalvingsMax && high - low > 1e-12 * high; ++halving) {
      const double middle = (low + high) / 2;
      (is_positive == (value_at(p, middle) > 0) ? low : high) = middle;
    }
    found.push_back(low);
  }
  return found;
}

double first_sign_change(const Polynomial& p, double limit) {
  const std::vector<double> all = sign_changes(p, limit);
  return all.empty() ? limit : all.front();
}

/// The radial factor N(q) / D(q) of the squared slope q.
struct RadialFactor {
  double value;
  double by_q;
};

RadialFactor radial_factor(const CameraIntrinsics& c, double q) {
  const double above = 1 + q * (c.k1 + q * (c.k2 + q * c.k3));
  const double above_by_q = c.k1 + q * (2 * c.k2 + q * 3 * c.k3);
  if (c.model == LensModel::kPlumbBob) return {above, above_by_q};
  const double below = 1 + q * (c.k4 + q * (c.k5 + q * c.k6));
  const double below_by_q = c.k4 + q * (2 * c.k5 + q * 3 * c.k6);
  return {above / below, (above_by_q * below - above * below_by_q) / square(below)};
}

DistortedSlopes brown_conrady(const CameraIntrinsics& c, const Vec2& slopes) {
  const double x = slopes.x(), y = slopes.y(), q = x * x + y * y, p1 = c.p1, p2 = c.p2;
  const auto [radial, by_q] = radial_factor(c, q);
  const double twice_radial_by_q = 2 * by_q;
  const double mixed = x * y * twice_radial_by_q + 2 * p1 * x + 2 * p2 * y;
  DistortedSlopes result;
  result.slopes = {x * radial + 2 * p1 * x * y + p2 * (q + 2 * x * x),
                   y * radial + p1 * (q + 2 * y * y) + 2 * p2 * x * y};
  result.by_slopes << radial + x * x * twice_radial_by_q + 2 * p1 * y + 6 * p2 * x, mixed,  //
      mixed, radial + y * y * twice_radial_by_q + 6 * p1 * y + 2 * p2 * x;
  return result;
}

/// The radius at an angle is theta (1 + k1 theta^2 + k2 theta^4 + k3 theta^6 + k4 theta^8).
DistortedSlopes equidistant(const CameraIntrinsics& c, const Vec2& slopes) {
  constexpr double kOnAxis =
      1e-4;  // closer in, the quotients below lose their digits and the series is exact
  const double slope = slopes.norm(), theta = std::atan(slope), t = theta * theta;
  const double bent = 1 + t * (c.k1 + t * (c.k2 + t * (c.k3 + t * c.k4)));
  const double by_theta = 1 + t * (3 * c.k1 + t * (5 * c.k2 + t * (7 * c.k3 + t * 9 * c.k4)));
  double factor = 1 + (c.k1 - 1.0 / 3) * slope * slope, factor_growth = 2 * (c.k1 - 1.0 / 3);
  if (slope > kOnAxis) {
    factor = theta * bent / slope;
    factor_growth = (by_theta / (1 + slope * slope) - factor) / (slope * slope);
  }
  return {factor * slopes, factor * Mat2::Identity() + factor_growth * slopes * slopes.transpose()};
}

}  // namespace

DistortedSlopes distorted(const CameraIntrinsics& lens, const Vec2& slopes) {
  return lens.model == LensModel::kEquidistant ? equidistant(lens, slopes) : brown_conrady(lens, slopes);
}

double fold_slope_squared(const CameraIntrinsics& c) {
  if (c.model == LensModel::kEquidistant) {
    const Polynomial growth{1, 3 * c.k1, 5 * c.k2, 7 * c.k3, 9 * c.k4};
    return square(std::tan(std::sqrt(first_sign_change(growth, square(kWidestAngle_rad)))));
  }
  const Polynomial above{1, c.k1, c.k2, c.k3};
  if (c.model == LensModel::kPlumbBob)
    return first_sign_change({1, 3 * c.k1, 5 * c.k2, 7 * c.k3}, kWidestSlopeSquared);
  // The growth of r N / D is (N D + 2 q (N' D - N D')) / D^2.
  const Polynomial below{1, c.k4, c.k5, c.k6};
  Polynomial growth = above * below;
  const Polynomial first = derivative(above) * below, second = above * derivative(below);
  for (std::size_t i = 0; i < first.size(); ++i) growth[i + 1] += 2 * (first[i] - second[i]);
  return first_sign_change(growth, first_sign_change(below, kWidestSlopeSquared));
}

}  // namespace aisle
