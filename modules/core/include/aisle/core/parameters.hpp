#pragma once
/// Parameters are plain structs with good defaults. Each struct describes its fields once:
///
///   struct SegmentParams {
///     double range_max_m = 25;
///     void describe(FieldList& fields) {
///       fields.real("range_max_m", range_max_m, {1, 200}, "farther readings are not used");
///     }
///   };
///
/// That one list reads parameter files and `--set`, checks ranges, and prints `--help` and the documentation.

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "aisle/core/problem.hpp"

namespace aisle {

struct Range {
  double min = 0;
  double max = 0;
};

/// One parameter: its key, its meaning and the variable that it sets.
struct Field {
  std::string key;  ///< dotted, with the unit as suffix: "segments.range_max_m"
  std::string doc;
  Range range;            ///< allowed values, inclusive, in the key's unit
  double inner_unit = 1;  ///< the variable is the key's value times this (degrees -> radians)
  std::variant<double*, int*, bool*> target;

  /// The present value in the key's unit, in as few digits as it takes to read the same value.
  std::string value_text() const;
};

class FieldList {
 public:
  void real(std::string_view key, double& target, Range range, std::string_view doc);
  /// The key ends in _deg, the variable holds radians.
  void angle(std::string_view key, double& target_rad, Range range_deg, std::string_view doc);
  void count(std::string_view key, int& target, Range range, std::string_view doc);
  void flag(std::string_view key, bool& target, std::string_view doc);

  /// The fields of `params` under the prefix "name.".
  template <class Params>
  void group(std::string_view name, Params& params) {
    const std::string outer = prefix_;
    prefix_ += std::string(name) + ".";
    params.describe(*this);
    prefix_ = outer;
  }

  const std::vector<Field>& all() const& { return fields_; }
  const std::vector<Field>& all() && = delete;  ///< a loop over them would outlive the list

  /// Sets the field `key` from `text`; an unknown key, an unreadable or an out-of-range value is a problem
  /// that names key, value and range.
  Problems assign(std::string_view key, std::string_view text, Place where);

 private:
  void add(std::string_view key, std::string_view doc, Range range, double inner_unit,
           std::variant<double*, int*, bool*> target);

  std::string prefix_;
  std::vector<Field> fields_;
};

/// The fields of a parameter struct; valid as long as `params` lives.
template <class Params>
FieldList fields_of(Params& params) {
  FieldList fields;
  params.describe(fields);
  return fields;
}

}  // namespace aisle
