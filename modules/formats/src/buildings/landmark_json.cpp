#include "buildings/building_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr Range kSigma_m = {1e-6, 1e3};
constexpr double kWeightMax = 1e9;
constexpr double kCorrelationMax = 0.9999;  // as close to 1 as the written digits can express
constexpr double kDistanceMax_m = 1000;
constexpr std::size_t kLandmarksMax = 1'000'000;
constexpr Digits kSigmaDigits = {3, Digits::Kind::kSignificant};
constexpr Digits kWeightDigits = {4, Digits::Kind::kSignificant};
constexpr std::array<std::string_view, 2> kBrighterSides = {"right", "left"};

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

/// Rounded to the degree; left out if unknown.
JsonPart seen_from_part(std::string_view key, Vec2& seen_from) {
  return {key,
          [&seen_from] {
            if (seen_from.isZero()) return std::string();
            return std::to_string(std::lround(to_degrees(heading_of(seen_from))));
          },
          [&seen_from](const JsonValue& value) {
            double heading_rad = 0;
            read_field(value, field::angle("", heading_rad));
            seen_from = unit(heading_rad);
          }};
}

/// [nearest, farthest], rounded to the centimetre; left out if unknown.
JsonPart distances_part(std::string_view key, Landmark& landmark) {
  return {key,
          [&landmark] {
            if (!std::isfinite(landmark.seen_far_m)) return std::string();
            return fmt::format("[{},{}]", decimals(landmark.seen_near_m, 2),
                               decimals(landmark.seen_far_m, 2));
          },
          [&landmark](const JsonValue& value) {
            if (!value.is_list_of(2)) return;
            value.element(0).read_number(landmark.seen_near_m, {0, kDistanceMax_m});
            value.element(1).read_number(landmark.seen_far_m, {landmark.seen_near_m, kDistanceMax_m});
          }};
}

/// @param spread  of the landmark's position, instead of its covariance
JsonFields landmark_fields(Landmark& landmark, Spread& spread) {
  return {needed(field::point("at_m", landmark.p_map, kMapCoordinate_m)),
          needed(field::point("sigma_m", spread.sigma_m, kSigma_m, kSigmaDigits)),
          field::number("correlation", spread.correlation, {-kCorrelationMax, kCorrelationMax}, {4}),
          field::number("mass", landmark.mass, {0, kWeightMax}, kWeightDigits),
          field::number("weight", landmark.weight, {1e-9, kWeightMax}, kWeightDigits),
          field::count("sightings", landmark.sightings),
          field::count("passes", landmark.passes),
          seen_from_part("seen_from_deg", landmark.seen_from),
          distances_part("seen_from_m", landmark),
          needed(brighter_field("brighter", landmark.brighter_right))};
}

Landmark read_landmark(const JsonValue& value) {
  Landmark landmark;
  Spread spread;
  if (!read_object(value, landmark_fields(landmark, spread))) return {};
  landmark.covariance = covariance_of(spread);
  return landmark;
}

/// A table, because a file has many of them.
std::string landmarks_json(const LandmarkMap& map) {
  Landmark landmark;
  Spread spread;
  const JsonFields fields = landmark_fields(landmark, spread);
  std::vector<std::string> rows;
  for (const Landmark& written : map.all()) {
    const bool is_gap = written.weight == 0;
    if (is_gap) continue;
    landmark = written;
    spread = spread_of(written.covariance);
    rows.push_back(row_json(fields));
  }
  return fmt::format(R"({{"columns": ["{}"], "rows": {}}})", fmt::join(keys_of(fields), R"(", ")"),
                     list_json(rows));
}

}  // namespace

ObjectField brighter_field(std::string_view key, bool& is_right) {
  return {.key = key,
          .target = WordTarget{kBrighterSides, [&is_right] { return is_right ? std::size_t{0} : 1; },
                               [&is_right](std::size_t side) { is_right = side == 0; }}};
}

JsonPart landmarks_part(std::string_view key, LandmarkMap& map) {
  return {key, [&map] { return map.empty() ? std::string() : landmarks_json(map); },
          [&map](const JsonValue& value) {
            value.for_each_object(kLandmarksMax,
                                  [&map](const JsonValue& landmark) { map.add(read_landmark(landmark)); });
          }};
}

}  // namespace aisle
