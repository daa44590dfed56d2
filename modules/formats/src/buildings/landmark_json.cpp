#include "buildings/landmark_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/core/parameters.hpp"
#include "buildings/json_text.hpp"

namespace aisle {
namespace {

constexpr Range kSigma_m = {1e-6, 1e3};
constexpr Range kWeight = {1e-9, 1e9};
constexpr double kCorrelationMax = 0.9999;  // as close to 1 as the written digits can express
constexpr double kDistanceMax_m = 1000;
constexpr std::size_t kLandmarksMax = 1'000'000;
/// In the order of the columns.
constexpr std::array<std::string_view, 10> kKeys = {
    "at_m",      "sigma_m", "correlation",   "mass",        "weight",
    "sightings", "passes",  "seen_from_deg", "seen_from_m", "brighter"};

struct Spread {
  Vec2 sigma_m = Vec2::Ones();
  double correlation = 0;
};

Spread spread_of(const Mat2& covariance) {
  const Vec2 sigma_m = covariance.diagonal().cwiseSqrt().cwiseMax(kSigma_m.min);
  const double correlation = covariance(0, 1) / (sigma_m.x() * sigma_m.y());
  return {sigma_m, std::clamp(correlation, -kCorrelationMax, kCorrelationMax)};
}

Mat2 covariance_of(const Spread& spread) {
  Mat2 correlations;
  correlations << 1, spread.correlation, spread.correlation, 1;
  return spread.sigma_m.asDiagonal() * correlations * spread.sigma_m.asDiagonal();
}

/// Rounded to the degree; null if unknown.
std::string heading_json(const Vec2& seen_from) {
  if (seen_from.isZero()) return "null";
  return std::to_string(std::lround(to_degrees(std::atan2(seen_from.y(), seen_from.x()))));
}

/// Rounded to the centimetre; null if unknown.
std::string distances_json(const Landmark& landmark) {
  if (!std::isfinite(landmark.seen_far_m)) return "null";
  return fmt::format("[{},{}]", decimals(landmark.seen_near_m, 2), decimals(landmark.seen_far_m, 2));
}

/// Without spaces, because a file has many rows.
std::string landmark_row(const Landmark& landmark) {
  const Spread spread = spread_of(landmark.covariance);
  return fmt::format(R"([[{},{}],[{:.3g},{:.3g}],{},{:.4g},{:.4g},{},{},{},{},"{}"])",
                     decimals(landmark.p_map.x(), kMillimetreDecimals),
                     decimals(landmark.p_map.y(), kMillimetreDecimals), spread.sigma_m.x(),
                     spread.sigma_m.y(), decimals(spread.correlation, 4), landmark.mass, landmark.weight,
                     landmark.sightings, landmark.passes, heading_json(landmark.seen_from),
                     distances_json(landmark), brighter_text(landmark.brighter_right));
}

Mat2 read_covariance(const JsonValue& value) {
  Spread spread;
  if (const auto sigma = value.require("sigma_m"); sigma && sigma->is_list_of(2)) {
    sigma->element(0).read_number(spread.sigma_m.x(), kSigma_m.min, kSigma_m.max);
    sigma->element(1).read_number(spread.sigma_m.y(), kSigma_m.min, kSigma_m.max);
  }
  if (const auto correlation = value.find("correlation"))
    correlation->read_number(spread.correlation, -kCorrelationMax, kCorrelationMax);
  return covariance_of(spread);
}

void read_distances(const JsonValue& value, Landmark& landmark) {
  if (!value.is_list_of(2)) return;
  value.element(0).read_number(landmark.seen_near_m, 0, kDistanceMax_m);
  value.element(1).read_number(landmark.seen_far_m, landmark.seen_near_m, kDistanceMax_m);
}

Landmark read_landmark(const JsonValue& value) {
  Landmark landmark;
  if (!value.is_object_of({kKeys.begin(), kKeys.end()})) return landmark;
  if (const auto at = value.require("at_m")) at->read_point(landmark.p_map);
  landmark.covariance = read_covariance(value);
  if (const auto mass = value.find("mass")) mass->read_number(landmark.mass, 0, kWeight.max);
  if (const auto weight = value.find("weight"))
    weight->read_number(landmark.weight, kWeight.min, kWeight.max);
  if (const auto sightings = value.find("sightings")) sightings->read_count(landmark.sightings);
  if (const auto passes = value.find("passes")) passes->read_count(landmark.passes);
  if (const auto seen_from = value.find("seen_from_deg")) {
    double heading_deg = 0;
    seen_from->read_number(heading_deg, -360, 360);
    landmark.seen_from = unit(heading_deg * kDegree);
  }
  if (const auto seen_from = value.find("seen_from_m")) read_distances(*seen_from, landmark);
  if (const auto brighter = value.require("brighter")) read_brighter(*brighter, landmark.brighter_right);
  return landmark;
}

}  // namespace

const char* brighter_text(bool is_right) {
  return is_right ? "right" : "left";
}

void read_brighter(const JsonValue& value, bool& is_right) {
  if (!value.is("right") && !value.is("left")) return value.wrong(R"(is neither "right" nor "left")");
  is_right = value.is("right");
}

std::string landmarks_json(const LandmarkMap& map) {
  std::vector<std::string> rows;
  for (const Landmark& landmark : map.all()) {
    const bool is_gap = landmark.weight == 0;
    if (!is_gap) rows.push_back(landmark_row(landmark));
  }
  return fmt::format(R"({{"columns": ["{}"], "rows": {}}})", fmt::join(kKeys, R"(", ")"), list_json(rows));
}

LandmarkMap read_landmarks(const JsonValue& value) {
  LandmarkMap map;
  value.for_each_object(kLandmarksMax, [&](const JsonValue& landmark) { map.add(read_landmark(landmark)); });
  return map;
}

}  // namespace aisle
