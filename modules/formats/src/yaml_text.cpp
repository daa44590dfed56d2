#include "yaml_text.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "field_reader.hpp"

namespace aisle {
namespace {

constexpr int kYamlLevelsMax = 32;
constexpr std::size_t kValuesMax = 2'000'000;

/// Follows a document without keeping it.
class YamlLimits final : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override { count(mark); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override { count(mark); }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t, const std::string&) override {
    count(mark);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    descend(mark);
  }
  void OnSequenceEnd() override { --levels_; }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    descend(mark);
  }
  void OnMapEnd() override { --levels_; }

 private:
  void count(const YAML::Mark& mark) {
    if (++values_ > kValuesMax)
      throw YAML::ParserException(mark, fmt::format("more than {} values", kValuesMax));
  }
  void descend(const YAML::Mark& mark) {
    count(mark);
    if (++levels_ > kYamlLevelsMax)
      throw YAML::ParserException(mark, fmt::format("more than {} levels", kYamlLevelsMax));
  }

  int levels_ = 0;
  std::size_t values_ = 0;
};

}  // namespace

YAML::Node load_yaml(std::string_view text) {
  const std::string document(text);
  std::istringstream once(document), again(document);
  YamlLimits limits;
  YAML::Parser(once).HandleNextDocument(limits);
  return YAML::Load(again);
}

std::string yaml_quoted(const std::string& text) {
  YAML::Emitter out;
  out << YAML::DoubleQuoted << text;
  return out.c_str();
}

bool is_line_of_text(const std::string& text) {
  const auto is_control = [](unsigned char c) { return c < ' ' || c == 127; };
  return std::none_of(text.begin(), text.end(), is_control) && YAML::Load(yaml_quoted(text)).Scalar() == text;
}

bool is_topic_word(std::string_view name) {
  constexpr std::size_t kLettersMax = 64;
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !name.empty() && name.size() <= kLettersMax && is_letter(name.front()) &&
         std::all_of(name.begin(), name.end(),
                     [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; });
}

void add_duplicate_keys(const YAML::Node& map, ProblemList& problems) {
  std::map<std::string, long> first_lines;
  for (const auto& entry : map) {
    if (!entry.first.IsScalar()) continue;
    const long line = entry.first.Mark().line + 1;
    const auto [first, is_new] = first_lines.emplace(entry.first.Scalar(), line);
    if (!is_new)
      problems.add(line, printable(entry.first.Scalar()),
                   fmt::format("is given twice, first on line {}", first->second));
  }
}

}  // namespace aisle
