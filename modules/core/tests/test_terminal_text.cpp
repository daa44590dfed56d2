#include <gtest/gtest.h>

#include "aisle/core/terminal_text.hpp"

namespace aisle {
namespace {

TEST(TerminalText, WhatCanBeReadStays) {
  const std::string text = "Fl\u00e4che 3 m\u00b2, \u706b, \U0001F916\nnext line";
  EXPECT_EQ(terminal_text(text), text);
}

TEST(TerminalText, WhatMovesACursorIsShownAsItIsWritten) {
  EXPECT_EQ(terminal_text("\x1b[2J\r\x7f"), "\\x1b[2J\\x0d\\x7f");
  EXPECT_EQ(terminal_text("\u009b2J"), "\\u009b2J");
  EXPECT_EQ(terminal_text("a\u202eb"), "a\\u202eb");
}

TEST(TerminalText, BytesThatAreNoUtf8AreShownAsBytes) {
  EXPECT_EQ(terminal_text("\xff"), "\\xff");
  EXPECT_EQ(terminal_text("\xc3"), "\\xc3");                 // cut off
  EXPECT_EQ(terminal_text("\xc0\x8a"), "\\xc0\\x8a");        // a line end in two bytes
  EXPECT_EQ(terminal_text("\xed\xa0\x80").size(), 12U);      // half a pair
  EXPECT_EQ(terminal_text("\xf4\x90\x80\x80").size(), 16U);  // beyond Unicode
}

}  // namespace
}  // namespace aisle
