#pragma once
/// A stand-in for the mms simulator: answers its protocol on two pipes, and notes illegal commands.

#include <unistd.h>

#include <array>
#include <cstdio>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>

#include "aisle/exploration/grid_world.hpp"

namespace aisle {

class MmsStandIn {
 public:
  explicit MmsStandIn(GridWorld world) : world_(std::move(world)) {
    if (pipe(to_mouse_.data()) != 0 || pipe(from_mouse_.data()) != 0) throw std::runtime_error("pipe");
  }
  MmsStandIn(const MmsStandIn&) = delete;
  ~MmsStandIn() {
    close_mouse_end();
    if (thread_.joinable()) thread_.join();
  }

  /// The reset button is pressed after so many forward moves.
  void press_reset_after(int count) { reset_after_ = count; }
  /// The simulator ends after so many forward moves.
  void leave_after(int count) { leave_after_ = count; }
  /// Replies this to every movement.
  void answer_moves_with(std::string reply) { move_reply_ = std::move(reply); }

  void start() {
    thread_ = std::thread([this] { serve(); });
  }
  /// Waits for the mouse's last command.
  void finish() {
    close_mouse_end();
    thread_.join();
  }

  int replies_fd() const { return to_mouse_[0]; }
  int commands_fd() const { return from_mouse_[1]; }

  std::string illegal;                    ///< the first command that mms would not take
  std::set<std::pair<int, int>> visited;  ///< since the last reset
  int crashes = 0;
  int resets = 0;
  int moves = 0;  ///< forward, each of any length
  Cell at;

 private:
  void close_mouse_end() {
    if (from_mouse_[1] >= 0) close(from_mouse_[1]);
    from_mouse_[1] = -1;
  }

  void serve() {
    visited = {{0, 0}};
    FILE* commands = fdopen(from_mouse_[0], "r");
    std::array<char, 256> line{};
    while (illegal.empty() && !gone_ && std::fgets(line.data(), line.size(), commands) != nullptr) {
      if (std::string(line.data()).find('\n') == std::string::npos) illegal = "a line without an end";
      obey(line.data());
    }
    std::fclose(commands);
    close(to_mouse_[1]);
  }

  void obey(const std::string& line) {
    std::istringstream words(line);
    std::string command, extra;
    words >> command;
    if (command == "mazeWidth") return answer(words, std::to_string(world_.width()));
    if (command == "mazeHeight") return answer(words, std::to_string(world_.height()));
    for (int turn = 0; turn < 4; ++turn) {
      if (command == kWalls[turn]) return answer(words, is_open(heading_ + turn) ? "false" : "true");
    }
    if (command == "turnRight") return turn(words, 1);
    if (command == "turnLeft") return turn(words, 3);
    if (command == "moveForward") return move(words);
    if (command == "wasReset") return answer(words, is_reset_ ? "true" : "false");
    if (command == "ackReset") return acknowledge(words, line);
    int x = -1, y = -1;
    char mark = 0;
    words >> x >> y >> mark;
    const std::string marks = command == "setWall" ? "nesw" : command == "setColor" ? "kbacgorwyBCAGRY" : "";
    const bool known = !words.fail() && marks.find(mark) != std::string::npos && world_.contains({x, y});
    if (!known || words >> extra) illegal = line;
  }

  void answer(std::istringstream& rest, const std::string& reply) {
    std::string extra;
    if (rest >> extra) illegal = "too many words: " + extra;
    const std::string text = reply + "\n";
    if (write(to_mouse_[1], text.data(), text.size()) < 0) gone_ = true;
  }

  void turn(std::istringstream& rest, int quarters) {
    heading_ = (heading_ + quarters) % 4;
    answer(rest, move_reply_);
  }

  void move(std::istringstream& words) {
    int cells = 1;
    std::string word;
    if (words >> word) cells = std::stoi(word);
    if (moves == leave_after_) {
      gone_ = true;
      return;
    }
    for (int i = 0; i < cells; ++i) {
      if (!is_open(heading_)) {
        ++crashes;
        return answer(words, "crash");
      }
      at = neighbour(at, kClockwise[heading_]);
      visited.insert({at.x, at.y});
    }
    if (++moves == reset_after_) is_reset_ = true;
    answer(words, move_reply_);
  }

  void acknowledge(std::istringstream& rest, const std::string& line) {
    if (!is_reset_) illegal = line;
    is_reset_ = false;
    ++resets;
    at = {};
    heading_ = 0;
    visited = {{0, 0}};
    answer(rest, "ack");
  }

  bool is_open(int quarters) const { return contains(world_.open(at), kClockwise[quarters % 4]); }

  static constexpr Side kClockwise[] = {Side::kTop, Side::kRight, Side::kBottom, Side::kLeft};
  static constexpr const char* kWalls[] = {"wallFront", "wallRight", "wallBack", "wallLeft"};

  GridWorld world_;
  std::array<int, 2> to_mouse_{};
  std::array<int, 2> from_mouse_{};
  std::thread thread_;
  std::string move_reply_ = "ack";
  int heading_ = 0;
  int reset_after_ = -1;
  int leave_after_ = -1;
  bool is_reset_ = false;
  bool gone_ = false;
};

}  // namespace aisle
