#include <optional>

#include "aisle/guidance/key_controls.hpp"

namespace aisle {
namespace {

constexpr char kEscape = '\x1b';
constexpr std::size_t kLabelMax = 64;
constexpr int kTurnings = 13;

std::optional<Key::Kind> arrow(char last) {
  switch (last) {
    case 'A':
      return Key::Kind::kUp;
    case 'B':
      return Key::Kind::kDown;
    case 'C':
      return Key::Kind::kRight;
    case 'D':
      return Key::Kind::kLeft;
    default:
      return std::nullopt;
  }
}

Key mark(Mark::Kind kind, const std::string& label) {
  return {Key::Kind::kMark, {kind, label}};
}

bool is_turning(const std::string& label) {
  const bool is_short = label.size() == 1 || label.size() == 2;
  return is_short && std::stoi(label) >= 1 && std::stoi(label) <= kTurnings;
}

}  // namespace

std::vector<Key> TerminalKeys::read(std::string_view bytes) {
  std::vector<Key> keys;
  for (const char byte : bytes) {
    const bool begins = byte == kEscape;
    const bool continues = escape_.size() == 1 && (byte == '[' || byte == 'O');
    if (begins || continues) {
      escape_ = begins ? std::string(1, byte) : escape_ + byte;
      if (begins) typing_ = Typing::kNothing;
      continue;
    }
    if (escape_.size() == 2) {
      if (const auto kind = arrow(byte)) keys.push_back({.kind = *kind});
      escape_.clear();
      continue;
    }
    escape_.clear();
    typing_ == Typing::kNothing ? read_plain(byte, keys) : read_typed(byte, keys);
  }
  return keys;
}

void TerminalKeys::read_plain(char byte, std::vector<Key>& keys) {
  typed_.clear();
  switch (byte) {
    case 'q':
      return keys.push_back({.kind = Key::Kind::kStop});
    case ' ':
      return keys.push_back({.kind = Key::Kind::kQuit});
    case 'd':
      typing_ = Typing::kTurning;
      return;
    case 'p':
      typing_ = Typing::kPlace;
      return;
    case 'e':
      if (!turning_.empty()) keys.push_back(mark(Mark::Kind::kTurningEnds, turning_));
      turning_.clear();
      return;
    case 'x':
      return keys.push_back(mark(Mark::Kind::kStop, ""));
    default:
      return;
  }
}

void TerminalKeys::read_typed(char byte, std::vector<Key>& keys) {
  const bool is_digit = byte >= '0' && byte <= '9';
  const bool ends = byte == '\r' || byte == '\n';
  const bool takes_back = byte == '\x7f' || byte == '\b';
  if (takes_back && !typed_.empty()) {
    typed_.pop_back();
  } else if (ends) {
    if (typing_ == Typing::kPlace && !typed_.empty()) keys.push_back(mark(Mark::Kind::kPlace, typed_));
    if (typing_ == Typing::kTurning && is_turning(typed_)) {
      turning_ = typed_;
      keys.push_back(mark(Mark::Kind::kTurningBegins, turning_));
    }
    typing_ = Typing::kNothing;
  } else if (byte >= ' ' && byte <= '~' && typed_.size() < kLabelMax &&
             (typing_ == Typing::kPlace || is_digit)) {
    typed_ += byte;
  }
}

std::string TerminalKeys::typing() const {
  switch (typing_) {
    case Typing::kNothing:
      return "";
    case Typing::kTurning:
      return "turning: " + typed_;
    case Typing::kPlace:
      return "place: " + typed_;
  }
  return "";
}

}  // namespace aisle
