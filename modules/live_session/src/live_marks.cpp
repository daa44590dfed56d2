#include "live_marks.hpp"

#include <array>
#include <string_view>
#include <utility>

namespace aisle {
namespace {

constexpr std::array<std::pair<Mark::Kind, std::string_view>, 4> kMarkNames = {
    {{Mark::Kind::kPlace, "place"},
     {Mark::Kind::kStop, "stop"},
     {Mark::Kind::kTurningBegins, "turning begins"},
     {Mark::Kind::kTurningEnds, "turning ends"}}};

}  // namespace

std::optional<Mark::Kind> mark_kind(const std::string& name) {
  for (const auto& [kind, known] : kMarkNames)
    if (known == name) return kind;
  return std::nullopt;
}

std::string mark_text(const Mark& mark) {
  std::string text;
  for (const auto& [kind, name] : kMarkNames)
    if (kind == mark.kind) text = name;
  return mark.label.empty() ? text : text + " " + mark.label;
}

}  // namespace aisle
