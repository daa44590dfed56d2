#include "mazes/mms_mouse.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <istream>
#include <ostream>

namespace aisle {
namespace {

constexpr std::array<Side, 4> kClockwise = {Side::kTop, Side::kRight, Side::kBottom, Side::kLeft};
constexpr std::array<const char*, 4> kWallCommands = {"wallFront", "wallRight", "wallBack", "wallLeft"};
constexpr std::array<char, 4> kCompass = {'n', 'e', 's', 'w'};

std::size_t place(Side side) {
  std::size_t at = 0;
  while (kClockwise[at] != side) ++at;
  return at;
}

std::string shown(const std::string& reply) {
  return reply.size() > 40 ? reply.substr(0, 40) + "..." : reply;
}

}  // namespace

void MmsMouse::say(const std::string& command) const {
  commands_ << command << '\n' << std::flush;
}

std::string MmsMouse::ask(const std::string& command) {
  say(command);
  std::string reply;
  if (!std::getline(replies_, reply)) throw MmsFailure{"the simulator ended before it answered " + command};
  while (!reply.empty() && (reply.back() == '\r' || reply.back() == ' ')) reply.pop_back();
  return reply;
}

bool MmsMouse::ask_yes_no(const std::string& command) {
  const std::string reply = ask(command);
  if (reply != "true" && reply != "false") {
    throw MmsFailure{fmt::format("'{}' is no answer to {}; true and false are", shown(reply), command)};
  }
  return reply == "true";
}

void MmsMouse::act(const std::string& command) {
  const std::string reply = ask(command);
  if (reply == "crash") throw MmsCrash{};
  if (reply != "ack") throw MmsFailure{fmt::format("'{}' is no answer to {}; ack is", shown(reply), command)};
}

int MmsMouse::size(const std::string& dimension) {
  const std::string reply = ask(dimension);
  int size = 0;
  const auto [end, error] = std::from_chars(reply.data(), reply.data() + reply.size(), size);
  if (error == std::errc() && end == reply.data() + reply.size() && size >= 1 && size <= GridShape::kMaxSize)
    return size;
  throw MmsFailure{fmt::format("{} is '{}', not a whole number from 1 to {}", dimension, shown(reply),
                               GridShape::kMaxSize)};
}

Sides MmsMouse::sense() {
  Sides open = kNoSides;
  for (std::size_t turn = 0; turn < 4; ++turn) {
    if (!ask_yes_no(kWallCommands[turn])) open |= bit(kClockwise[(place(heading_) + turn) % 4]);
  }
  return open;
}

void MmsMouse::turn_to(Side side) {
  const std::size_t turn = (place(side) + 4 - place(heading_)) % 4;
  if (turn == 3) {
    act("turnLeft");
  } else {
    for (std::size_t i = 0; i < turn; ++i) act("turnRight");
  }
  heading_ = side;
}

void MmsMouse::move(Side side, int cells) {
  turn_to(side);
  act(cells == 1 ? std::string("moveForward") : fmt::format("moveForward {}", cells));
  for (int i = 0; i < cells; ++i) at_ = neighbour(at_, side);
}

bool MmsMouse::take_reset() {
  if (!ask_yes_no("wasReset")) return false;
  act("ackReset");
  at_ = {};
  heading_ = Side::kTop;
  return true;
}

void MmsMouse::show(Sides open, char color) {
  for (const Side side : kAllSides) {
    if (!contains(open, side)) say(fmt::format("setWall {} {} {}", at_.x, at_.y, kCompass[place(side)]));
  }
  say(fmt::format("setColor {} {} {}", at_.x, at_.y, color));
}

}  // namespace aisle
