#include "authenticator.hpp"

#include <gtest/gtest.h>

namespace aisle {
namespace {

const Authenticator kLocal(true, "");
const Authenticator kOpen(false, "a very secret word");

TEST(Authenticator, AcceptsProgramsAndItsOwnPage) {
  EXPECT_TRUE(kLocal.is_from_here({.host = "127.0.0.1:8765"}));
  EXPECT_TRUE(kLocal.is_from_here({.host = "localhost:8765", .origin = "http://localhost:8765"}));
  EXPECT_TRUE(kLocal.is_from_here({.host = "[::1]:8765", .origin = "http://[::1]:8765"}));
  EXPECT_TRUE(kOpen.is_from_here({.host = "robot.lan:8765", .origin = "https://robot.lan:8765"}));
}

TEST(Authenticator, RefusesPagesOfOtherSites) {
  for (const char* origin : {"http://evil.example", "http://localhost:9999", "null", "localhost:8765",
                             "http://localhost:8765.evil.example", "http://evil.example/localhost:8765"})
    EXPECT_FALSE(kLocal.is_from_here({.host = "localhost:8765", .origin = origin})) << origin;
}

TEST(Authenticator, AcceptsPagesOfAllowedSitesAlone) {
  const Authenticator allowing(true, "", {"https://viewer.example"});
  EXPECT_TRUE(allowing.is_from_here({.host = "localhost:8765", .origin = "https://viewer.example"}));
  for (const char* origin : {"http://viewer.example", "https://viewer.example:8443", "https://evil.example",
                             "https://viewer.example.evil.example"})
    EXPECT_FALSE(allowing.is_from_here({.host = "localhost:8765", .origin = origin})) << origin;
  EXPECT_FALSE(allowing.is_from_here({.host = "evil.example", .origin = "https://viewer.example"}));
}

TEST(Authenticator, KnowsWhatAnOriginIs) {
  EXPECT_TRUE(is_origin("https://viewer.example"));
  EXPECT_TRUE(is_origin("http://localhost:8080"));
  for (const char* text :
       {"", "*", "https://", "viewer.example", "https://viewer.example/", "https://*.example"})
    EXPECT_FALSE(is_origin(text)) << text;
}

TEST(Authenticator, RefusesForeignNamesThatPointHere) {
  EXPECT_FALSE(kLocal.is_from_here({.host = "evil.example:8765", .origin = "http://evil.example:8765"}));
  EXPECT_FALSE(kLocal.is_from_here({.host = ""}));
}

TEST(Authenticator, AsksForTheTokenIfThereIsOne) {
  EXPECT_TRUE(kLocal.knows_token({.target = "/"}));
  EXPECT_FALSE(kOpen.knows_token({.target = "/"}));
  EXPECT_FALSE(kOpen.knows_token({.target = "/?token=a+very+secret+word"}));
  EXPECT_FALSE(kOpen.knows_token({.target = "/?tokens=a%20very%20secret%20word"}));
  EXPECT_FALSE(kOpen.knows_token({.authorization = "Bearer a very secret wor", .target = "/"}));
  EXPECT_TRUE(kOpen.knows_token({.target = "/?x=1&token=a%20very%20secret%20word"}));
  EXPECT_TRUE(kOpen.knows_token({.authorization = "Bearer a very secret word", .target = "/"}));
}

}  // namespace
}  // namespace aisle
