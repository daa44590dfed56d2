#pragma once
/// A navigator's parameters in a session: only those that differ from their defaults, key -> value.

#include <map>
#include <string>

#include "aisle/core/parameters.hpp"

namespace aisle {

using ParameterTexts = std::map<std::string, std::string>;

/// The fields whose values differ from those of `shipped`, which has the same fields.
ParameterTexts changed_fields(const FieldList& fields, const FieldList& shipped);

/// Sets every field that the texts name. @return all problems at once; empty on success
Problems assign_all(FieldList& fields, const ParameterTexts& texts);

template <class Params>
ParameterTexts changed_parameters(Params params) {
  Params shipped;
  return changed_fields(fields_of(params), fields_of(shipped));
}

template <class Params>
Problems assign_all(Params& params, const ParameterTexts& texts) {
  FieldList fields = fields_of(params);
  return assign_all(fields, texts);
}

}  // namespace aisle
