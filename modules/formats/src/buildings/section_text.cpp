#include "aisle/formats/buildings/section_text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "buildings/json_text.hpp"

namespace aisle {
namespace {

using Kind = Section::Kind;

constexpr double kSectionLengthMax_m = 10'000, kCornerMax_m = 10, kCornerMin_m = 0.05, kBesideMax_m = 20;
constexpr int kQuantaMax = 144;  // of a whole turn

char symbol_of(const Section& section) {
  switch (section.kind) {
    case Kind::kFollow:
      return 'a';
    case Kind::kHybrid:
      return 'h';
    case Kind::kDead:
      return 'd';
    case Kind::kCurve:
      return 'c';
    case Kind::kBack:
      return 'b';
    case Kind::kTurn:
      return section.turn_rad > 0 ? 'l' : 'r';
  }
  return '?';
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(" \t\r"); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(" \t\r", at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(" \t\r", end);
  }
  return words;
}

std::optional<double> number(std::string_view word) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Reads the words after the symbol.
class SectionParser {
 public:
  explicit SectionParser(const std::vector<std::string_view>& words) : words_(words) {}

  Result<Section> parse() {
    if (words_.empty()) return wrong("is empty; it begins with one of a, h, d, b, c, l, r");
    if (words_.front() == "a") return straight(Kind::kFollow, true);
    if (words_.front() == "h") return straight(Kind::kHybrid, true);
    if (words_.front() == "d") return straight(Kind::kDead, false);
    if (words_.front() == "b") return straight(Kind::kBack, false);
    if (words_.front() == "c") return curve();
    if (words_.front() == "l") return turn(1);
    if (words_.front() == "r") return turn(-1);
    return wrong(
        fmt::format("'{}' is not a section; sections begin with a, h, d, b, c, l, r", words_.front()));
  }

 private:
  static Problem wrong(std::string what) { return {{}, std::move(what)}; }

  std::optional<double> within(std::size_t word, double above, double max) const {
    if (word >= words_.size()) return std::nullopt;
    const auto value = number(words_[word]);
    return value && *value > above && *value <= max ? value : std::nullopt;
  }

  Result<Section> straight(Kind kind, bool has_walls) const {
    const auto length_m = within(1, 0, kSectionLengthMax_m);
    if (!length_m)
      return wrong(fmt::format("'{}' needs a length in metres, more than 0 and up to {}", words_[0],
                               kSectionLengthMax_m));
    Section section{.kind = kind, .length_m = *length_m};
    for (std::size_t i = 2; i < words_.size(); i += 2) {
      auto* beside_m = !has_walls             ? nullptr
                       : words_[i] == "right" ? &section.right_m
                       : words_[i] == "left"  ? &section.left_m
                       : words_[i] == "ahead" ? &section.ahead_m
                                              : nullptr;
      if (beside_m == nullptr || beside_m->has_value()) {
        return wrong(
            fmt::format("'{}' is not understood{}", words_[i],
                        has_walls ? "; after the length come 'right', 'left' or 'ahead' and metres" : ""));
      }
      *beside_m = within(i + 1, 0, kBesideMax_m);
      if (!*beside_m)
        return wrong(fmt::format("'{}' needs metres, more than 0 and up to {}", words_[i], kBesideMax_m));
    }
    return section;
  }

  Result<Section> curve() const {
    const auto ahead_m = within(1, 0, kCornerMax_m), left_m = within(2, 0, kCornerMax_m);
    if (words_.size() != 3 || !ahead_m || !left_m || *ahead_m < kCornerMin_m || *left_m < kCornerMin_m) {
      return wrong(
          fmt::format("'c' needs metres ahead and to the left, {} to {}", kCornerMin_m, kCornerMax_m));
    }
    return Section{.kind = Kind::kCurve, .p_start_end = {*ahead_m, *left_m}};
  }

  Result<Section> turn(int side) const {
    const auto quanta = within(1, 0, kQuantaMax);
    if (words_.size() != 2 || !quanta || *quanta != std::round(*quanta)) {
      return wrong(fmt::format("'{}' needs a whole number of turns of {:g} degrees, 1 to {}", words_[0],
                               to_degrees(kTurnQuantum_rad), kQuantaMax));
    }
    return Section{.kind = Kind::kTurn, .turn_rad = side * *quanta * kTurnQuantum_rad};
  }

  const std::vector<std::string_view>& words_;
};

}  // namespace

std::string section_text(const Section& section) {
  std::string text(1, symbol_of(section));
  if (section.kind == Kind::kTurn)
    return text + fmt::format(" {}", std::lround(std::abs(section.turn_rad) / kTurnQuantum_rad));
  if (section.kind == Kind::kCurve) {
    return text + " " + decimals(section.p_start_end.x(), kMillimetreDecimals) + " " +
           decimals(section.p_start_end.y(), kMillimetreDecimals);
  }
  text += " " + decimals(section.length_m, kMillimetreDecimals);
  if (section.right_m) text += " right " + decimals(*section.right_m, kMillimetreDecimals);
  if (section.left_m) text += " left " + decimals(*section.left_m, kMillimetreDecimals);
  if (section.ahead_m) text += " ahead " + decimals(*section.ahead_m, kMillimetreDecimals);
  return text;
}

Result<Section> parse_section(std::string_view line) {
  const std::vector<std::string_view> words = words_of(line);
  return SectionParser(words).parse();
}

std::vector<SectionFault> section_faults(const SectionList& sections) {
  std::vector<SectionFault> faults;
  const auto is_turn = [&](std::size_t i) { return i < sections.size() && sections[i].kind == Kind::kTurn; };
  bool leads_somewhere = false;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const Kind kind = sections[i].kind;
    leads_somewhere = leads_somewhere || kind != Kind::kTurn;
    if (kind == Kind::kHybrid && !(is_turn(i + 1) && sections[i + 1].turn_rad < 0))
      faults.push_back({i, "'h' is not followed by a right turn"});
    if (kind == Kind::kDead && (i == 0 || !is_turn(i - 1) || !is_turn(i + 1)))
      faults.push_back({i, "'d' does not lie between two turns"});
    if (kind == Kind::kTurn && is_turn(i + 1))
      faults.push_back({i + 1, "is a turn after a turn: write both as one"});
  }
  if (!leads_somewhere) faults.push_back({0, "leads nowhere"});
  return faults;
}

}  // namespace aisle
