#include "camera_url.hpp"

#include <gtest/gtest.h>

namespace aisle {
namespace {

TEST(CameraUrl, IsSplitIntoLocationUserAndPassword) {
  const CameraUrl url = split_url("rtsp://admin:p%40ss:word@camera:554/live?profile=a@b");
  EXPECT_EQ(url.location, "rtsp://camera:554/live?profile=a@b");
  EXPECT_EQ(url.user, "admin");
  EXPECT_EQ(url.password, "p@ss:word");
}

TEST(CameraUrl, NeedsNoPassword) {
  EXPECT_EQ(split_url("http://camera/a@b").location, "http://camera/a@b");
  EXPECT_EQ(split_url("http://camera/a@b").user, "");
  EXPECT_EQ(split_url("http://guest@camera").location, "http://camera");
  EXPECT_EQ(split_url("http://guest@camera").user, "guest");
  EXPECT_EQ(split_url("http://guest@camera").password, "");
  EXPECT_EQ(split_url("http://").location, "http://");
}

TEST(CameraUrl, KeepsWhatIsNoPercentCode) {
  EXPECT_EQ(split_url("http://100%:5%x5%4@camera").user, "100%");
  EXPECT_EQ(split_url("http://100%:5%x5%4@camera").password, "5%x5%4");
}

TEST(CameraUrl, SecretsAreTakenOutOfTexts) {
  EXPECT_EQ(without_secrets("cannot open rtsp://admin:secret@camera/live now"),
            "cannot open rtsp://camera/live now");
  EXPECT_EQ(without_secrets("http://camera/video?user=admin&password=secret"), "http://camera/video?...");
  EXPECT_EQ(without_secrets("http://a:secret@b/ or\nhttps://c:secret@d#secret"),
            "http://b/ or\nhttps://d?...");
  EXPECT_EQ(without_secrets("http://camera/video?mail=a@b"), "http://...");
  EXPECT_EQ(without_secrets("no url at all: //"), "no url at all: //");
}

TEST(CameraUrl, SecretsThatAreNotEncodedAreTakenOutToo) {
  for (const char* url : {"rtsp://admin:secret/secret@camera/live", "rtsp://admin:secret?secret@camera/live",
                          "rtsp://admin:secret#secret@camera/live", "rtsp://admin:secret@secret@camera/live",
                          "location=\"rtsp://admin:secret\"secret@camera/live"})
    EXPECT_EQ(without_secrets(url).find("secret"), std::string::npos) << without_secrets(url);
}

}  // namespace
}  // namespace aisle
