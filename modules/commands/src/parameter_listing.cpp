#include "aisle/commands/parameter_listing.hpp"

#include "aisle/formats/parameter_file.hpp"

namespace aisle {

Outcome parameter_listing(const std::string& verb, const FieldList& fields) {
  Outcome outcome{.verb = verb, .text = parameters_yaml(fields)};
  nlohmann::ordered_json& params = outcome.figures["params"];
  for (const Field& field : fields.all()) {
    nlohmann::ordered_json& listed = params[field.key];
    listed["value"] = nlohmann::ordered_json::parse(field.value_text());
    if (!std::holds_alternative<bool*>(field.target)) {
      listed["min"] = field.range.min;
      listed["max"] = field.range.max;
    }
    listed["doc"] = field.doc;
  }
  return outcome;
}

}  // namespace aisle
