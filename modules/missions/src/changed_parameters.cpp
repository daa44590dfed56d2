#include "aisle/missions/changed_parameters.hpp"

namespace aisle {

ParameterTexts changed_fields(const FieldList& fields, const FieldList& shipped) {
  ParameterTexts texts;
  for (std::size_t i = 0; i < fields.all().size(); ++i) {
    const Field& field = fields.all()[i];
    if (field.value_text() != shipped.all()[i].value_text()) texts[field.key] = field.value_text();
  }
  return texts;
}

Problems assign_all(FieldList& fields, const ParameterTexts& texts) {
  Problems problems;
  for (const auto& [key, value] : texts) {
    const Problems wrong = fields.assign(key, value, {"", 0, key});
    problems.insert(problems.end(), wrong.begin(), wrong.end());
  }
  return problems;
}

}  // namespace aisle
