#include "aisle/formats/parameter_file.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <vector>

#include "aisle/formats/whole_file.hpp"
#include "parameter_tree.hpp"
#include "yaml_text.hpp"

namespace aisle {
namespace {

/// A field and the rest of its key below the maps that are already open.
struct NestedField {
  std::string_view key;
  const Field* field;
};

std::string comment_of(const Field& field) {
  if (std::holds_alternative<bool*>(field.target)) return fmt::format("# {} (true or false)", field.doc);
  return fmt::format("# {} ({:g} .. {:g})", field.doc, field.range.min, field.range.max);
}

void write_level(std::string& text, const std::vector<NestedField>& fields, std::size_t indent) {
  const std::string blanks(indent, ' ');
  std::vector<bool> written(fields.size());
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (written[i]) continue;
    const std::size_t dot = fields[i].key.find('.');
    if (dot == std::string_view::npos) {
      const Field& field = *fields[i].field;
      text += fmt::format("{}{}\n{}{}: {}\n", blanks, comment_of(field), blanks, fields[i].key,
                          field.value_text());
      continue;
    }
    const std::string_view prefix = fields[i].key.substr(0, dot + 1);
    std::vector<NestedField> group;
    for (std::size_t j = i; j < fields.size(); ++j) {
      if (!fields[j].key.starts_with(prefix)) continue;
      group.push_back({fields[j].key.substr(prefix.size()), fields[j].field});
      written[j] = true;
    }
    text += fmt::format("{}{}:\n", blanks, prefix.substr(0, dot));
    write_level(text, group, indent + 2);
  }
}

}  // namespace

Problems parse_parameters(std::string_view text, const std::string& name, FieldList& fields) {
  try {
    ParameterTree tree(name, fields);
    const YAML::Node root = load_yaml(text);
    if (!root.IsNull()) tree.read("", root);
    return tree.take_problems();
  } catch (const YAML::Exception& error) {
    return {{{name, error.mark.line + 1}, "is not well-formed YAML: " + error.msg}};
  }
}

Problems read_parameters(const std::filesystem::path& path, FieldList& fields) {
  const Result<std::string> text = read_whole_file(path);
  if (!text) return text.problems();
  return parse_parameters(*text, path.string(), fields);
}

std::string parameters_yaml(const FieldList& fields) {
  std::vector<NestedField> all;
  for (const Field& field : fields.all()) all.push_back({field.key, &field});
  std::string text;
  write_level(text, all, 0);
  return text;
}

}  // namespace aisle
