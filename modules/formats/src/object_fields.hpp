#pragma once
/// The keys of an object in a file, each described in one line: readers, writers and the tests of the
/// documentation go through these lists. Worlds, scenarios and buildings use them.

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// Numbers that are written as one list, wherever they are stored: mostly a point's coordinates.
struct PointTarget {
  std::vector<double*> coordinates;
};

/// One of a few words.
struct WordTarget {
  std::span<const std::string_view> words;
  std::function<std::size_t()> index;
  std::function<void(std::size_t)> choose;
};

using FieldTarget = std::variant<double*, int*, std::uint64_t*, bool*, PointTarget, std::vector<Vec2>*,
                                 std::string*, WordTarget>;

/// How a building's numbers are written; worlds have thousandths throughout.
struct Digits {
  int count = 3;  ///< positions are not more accurate than a millimetre
  enum class Kind {
    kDecimals,     ///< at most `count` after the point, without trailing zeros
    kAllDecimals,  ///< `count` after the point
    kSignificant   ///< at most `count` significant ones
  } kind = Kind::kDecimals;
};

/// One key of an object and the variable that it sets.
struct ObjectField {
  std::string_view key;
  FieldTarget target;
  Range range = {};       ///< of each number, inclusive, in the key's unit
  double inner_unit = 1;  ///< the variable is the key's value times this (degrees -> radians)
  Digits digits = {};
  bool is_needed = false;
};

/// Valid as long as the object lives.
using ObjectFields = std::vector<ObjectField>;

namespace field {

inline constexpr Range kAnyCount = {0, std::numeric_limits<int>::max()};

ObjectField number(std::string_view key, double& target, Range range, Digits digits = {});
/// The key ends in _deg, the variable holds radians.
ObjectField angle(std::string_view key, double& target_rad, Range range_deg = {-360, 360},
                  Digits digits = {});
ObjectField count(std::string_view key, int& target, Range range = kAnyCount);
ObjectField whole_number(std::string_view key, std::uint64_t& target);
ObjectField flag(std::string_view key, bool& target);
ObjectField text(std::string_view key, std::string& target);
ObjectField point(std::string_view key, double& x_m, double& y_m, Range range, Digits digits = {});
ObjectField point(std::string_view key, Vec2& target, Range range, Digits digits = {});
ObjectField point(std::string_view key, Vec3& target, Range range);
ObjectField points(std::string_view key, std::vector<Vec2>& target, Range range);

/// `words` in the order of the enumeration.
template <class Kind>
ObjectField word(std::string_view key, Kind& kind, std::span<const std::string_view> words) {
  return {.key = key,
          .target = WordTarget{words, [&kind] { return static_cast<std::size_t>(kind); },
                               [&kind](std::size_t index) { kind = static_cast<Kind>(index); }}};
}

}  // namespace field

/// The same, but a file without it is refused; and a text is not empty.
ObjectField needed(ObjectField field);

}  // namespace aisle
