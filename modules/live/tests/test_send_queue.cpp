#include "send_queue.hpp"

#include <gtest/gtest.h>

namespace aisle {
namespace {

OutFrame image(const std::string& head, std::size_t bytes = 1) {
  return {.head = head, .body = std::make_shared<const std::string>(bytes, 'x'), .may_be_lost = true};
}

TEST(SendQueue, GivesBackInOrder) {
  SendQueue queue;
  queue.push(image("a"));
  queue.push(image("b"));
  EXPECT_EQ(queue.pop()->head, "a");
  EXPECT_EQ(queue.pop()->head, "b");
  EXPECT_FALSE(queue.pop());
}

TEST(SendQueue, DropsTheOldestIfTooManyWait) {
  SendQueue queue;
  const std::size_t count = SendQueue::kFramesMax + 10;
  for (std::size_t i = 0; i < count; ++i) EXPECT_TRUE(queue.push(image(std::to_string(i))));
  EXPECT_EQ(queue.lost(), 10);
  EXPECT_EQ(queue.pop()->head, "10");
}

TEST(SendQueue, DropsTheOldestIfTheyAreTooLarge) {
  SendQueue queue;
  for (const char* head : {"a", "b", "c"}) EXPECT_TRUE(queue.push(image(head, SendQueue::kBytesMax / 2)));
  EXPECT_EQ(queue.pop()->head, "c");
  EXPECT_FALSE(queue.pop());
}

TEST(SendQueue, KeepsWhatMustNotBeDropped) {
  SendQueue queue;
  queue.push({.head = "answer", .body = {}});
  for (std::size_t i = 0; i < 2 * SendQueue::kFramesMax; ++i) queue.push(image("p"));
  EXPECT_EQ(queue.pop()->head, "answer");
}

TEST(SendQueue, OneMessageIsKeptHoweverLarge) {
  SendQueue queue;
  EXPECT_TRUE(queue.push(image("large", 2 * SendQueue::kBytesMax)));
  EXPECT_EQ(queue.pop()->head, "large");
}

TEST(SendQueue, ReportsAClientThatTakesNothing) {
  SendQueue queue;
  bool has_room = true;
  for (std::size_t i = 0; i <= SendQueue::kFramesMax; ++i)
    has_room = queue.push({.head = "answer", .body = {}});
  EXPECT_FALSE(has_room);
}

}  // namespace
}  // namespace aisle
