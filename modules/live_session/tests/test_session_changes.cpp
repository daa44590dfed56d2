#include "session_changes.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>

namespace aisle {
namespace fs = std::filesystem;
namespace {

using testing::HasSubstr;

class SessionChanges : public testing::Test {
 protected:
  SessionChanges() {
    for (const char* name : {"a", "b"}) {
      fs::create_directories(folder / name);
      std::ofstream(folder / name / "metadata.yaml") << "kept by " << name;
      std::ofstream(folder / name / "x_0.db3") << name;
    }
  }
  ~SessionChanges() override { fs::remove_all(folder); }

  std::string renamed(const nlohmann::json& arguments) const {
    return to_string(rename_session(folder, arguments));
  }
  std::string deleted(const nlohmann::json& arguments) const {
    return to_string(delete_session(folder, arguments));
  }

  const fs::path folder = fs::temp_directory_path() / ("aisle-changes-" + std::to_string(getpid()));
};

TEST_F(SessionChanges, ASessionGetsAnotherNameWithItsFiles) {
  EXPECT_EQ(renamed({{"session", "a"}, {"to", "c"}, {"lease", "t"}}), "");
  EXPECT_FALSE(fs::exists(folder / "a"));
  EXPECT_TRUE(fs::exists(folder / "c" / "metadata.yaml"));
  EXPECT_TRUE(fs::exists(folder / "c" / "x_0.db3"));
}

TEST_F(SessionChanges, NoSessionIsReplacedAndNothingLeavesTheFolder) {
  EXPECT_THAT(renamed({{"session", "a"}, {"to", "b"}}), HasSubstr("'b' is there already"));
  EXPECT_THAT(renamed({{"session", "a"}, {"to", "a"}}), HasSubstr("there already"));
  EXPECT_THAT(renamed({{"session", "none"}, {"to", "c"}}), HasSubstr("there is no 'none'"));
  for (const char* to : {"../c", ".c", "", "a/c"})
    EXPECT_THAT(renamed({{"session", "a"}, {"to", to}}), HasSubstr("to: ")) << to;
  EXPECT_THAT(renamed({{"session", "a"}}), HasSubstr("to: is missing"));
  EXPECT_THAT(renamed({{"session", "../a"}, {"to", "c"}}), HasSubstr("session: "));
  EXPECT_TRUE(fs::exists(folder / "a" / "x_0.db3"));
}

TEST_F(SessionChanges, ADeletedSessionIsGoneAndNoOther) {
  EXPECT_EQ(deleted({{"session", "a"}}), "");
  EXPECT_FALSE(fs::exists(folder / "a"));
  EXPECT_TRUE(fs::exists(folder / "b" / "x_0.db3"));
  EXPECT_THAT(deleted({{"session", "a"}}), HasSubstr("there is no 'a'"));
  EXPECT_THAT(deleted({{"session", ".."}}), HasSubstr("session: "));
}

TEST_F(SessionChanges, WhatIsNoPartOfASessionIsNotDeleted) {
  fs::create_directories(folder / "a" / "notes");
  EXPECT_THAT(deleted({{"session", "a"}}), HasSubstr("holds folders"));
  EXPECT_TRUE(fs::exists(folder / "a" / "x_0.db3"));
  const fs::path elsewhere = folder / "b";
  fs::create_directory_symlink(elsewhere, folder / "link");
  EXPECT_EQ(deleted({{"session", "link"}}), "");
  EXPECT_TRUE(fs::exists(elsewhere / "x_0.db3"));
}

}  // namespace
}  // namespace aisle
