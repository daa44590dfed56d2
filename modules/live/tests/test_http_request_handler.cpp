#include "http_request_handler.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "web_address.hpp"

namespace aisle {
namespace fs = std::filesystem;
namespace {

using testing::HasSubstr;

const char* const kBuilding = R"({"format": "aisle.building", "version": 1})";

class RequestHandler : public testing::Test {
 protected:
  RequestHandler() {
    fs::create_directories(root / "web/assets");
    fs::create_directories(root / "sessions/run");
    fs::create_directories(root / "sessions/no-session");
    fs::create_directories(root / "buildings");
    write("secret.txt", "secret");
    write("web/index.html", "<html>");
    write("web/assets/a.js", "1");
    write("web/.hidden", "hidden");
    write("sessions/run/metadata.yaml", "x");
    write("buildings/lab.json", kBuilding);
    fs::create_symlink(root / "secret.txt", root / "web/link.txt");
  }
  ~RequestHandler() override { fs::remove_all(root); }

  void write(const std::string& name, const std::string& text) const { std::ofstream(root / name) << text; }

  HttpReply get(std::string_view target) const {
    return handler.answer({.method = "GET", .target = target, .knows_token = true});
  }
  HttpReply post(std::string_view target, std::string_view body, bool has_lease = true) const {
    return handler.answer(
        {.method = "POST", .target = target, .body = body, .knows_token = true, .has_lease = has_lease});
  }

  const fs::path root = fs::temp_directory_path() / ("aisle-handler-" + std::to_string(getpid()));
  const HttpRequestHandler handler{{root / "web", root / "sessions", root / "buildings"}, "1.2"};
};

TEST_F(RequestHandler, ServesThePage) {
  EXPECT_EQ(get("/").file->filename(), "index.html");
  EXPECT_EQ(get("/?token=x").media_type, "text/html; charset=utf-8");
  EXPECT_EQ(get("/assets/a.js").media_type, "text/javascript; charset=utf-8");
  EXPECT_EQ(get("/missing.js").status, 404);
  EXPECT_EQ(get("/assets").status, 404);
}

TEST_F(RequestHandler, SendsThePageCompressedAndOnlyWhenItChanged) {
  write("web/assets/a.js.gz", "compressed");
  const HttpReply plain = get("/assets/a.js");
  EXPECT_FALSE(plain.is_gzip);
  EXPECT_TRUE(plain.is_for_ever);
  const auto ask = [&](std::string_view target, std::string_view tags) {
    return handler.answer({.method = "GET", .target = target, .takes_gzip = true, .known_tags = tags});
  };
  const HttpReply compressed = ask("/assets/a.js", "");
  EXPECT_TRUE(compressed.is_gzip);
  EXPECT_EQ(compressed.file->filename(), "a.js.gz");
  EXPECT_EQ(compressed.media_type, "text/javascript; charset=utf-8");
  EXPECT_NE(compressed.tag, plain.tag);
  EXPECT_EQ(ask("/assets/a.js", compressed.tag).status, 304);
  const HttpReply page = ask("/", compressed.tag);
  EXPECT_EQ(page.status, 200);
  EXPECT_FALSE(page.is_gzip);
  EXPECT_FALSE(page.is_for_ever);
  EXPECT_EQ(ask("/", "\"x\", " + page.tag).status, 304);
  write("web/index.html", "<html> again");
  EXPECT_EQ(ask("/", page.tag).status, 200);
}

TEST_F(RequestHandler, SaysHowThePageIsBuiltWhereItIsNot) {
  const HttpRequestHandler bare({}, "1.2");
  const HttpReply reply = bare.answer({.method = "GET", .target = "/"});
  EXPECT_EQ(reply.status, 200);
  EXPECT_THAT(reply.body, HasSubstr("npm run build"));
}

TEST_F(RequestHandler, ShowsNothingOutsideItsFolders) {
  for (const char* target :
       {"/../secret.txt", "/%2e%2e/secret.txt", "/assets/../../secret.txt", "/assets/..%2f..%2fsecret.txt",
        "/.hidden", "/link.txt", "/sessions/../secret.txt", "/sessions/%2e%2e/secret.txt", "/buildings/..",
        "/buildings//etc/passwd", "/sessions/run/%00", "/%zz", "/%2", "//etc/passwd", "/assets\\a.js"}) {
    const HttpReply reply = get(target);
    EXPECT_EQ(reply.status, 404) << target;
    EXPECT_FALSE(reply.file) << target;
  }
}

TEST_F(RequestHandler, ListsSessionsAndBuildings) {
  EXPECT_EQ(get("/sessions/").body, R"({"sessions":["run"]})");
  EXPECT_EQ(get("/buildings/").body, R"({"buildings":["lab"]})");
  EXPECT_EQ(get("/sessions/run/metadata.yaml").file->filename(), "metadata.yaml");
  EXPECT_EQ(get("/buildings/lab.json").media_type, "application/json");
}

TEST_F(RequestHandler, AsksForTheTokenBeforeItShowsWhatWasRecorded) {
  EXPECT_EQ(handler.answer({.method = "GET", .target = "/sessions/"}).status, 401);
  EXPECT_EQ(handler.answer({.method = "GET", .target = "/buildings/lab.json"}).status, 401);
  EXPECT_EQ(handler.answer({.method = "POST", .target = "/buildings/lab", .has_lease = true}).status, 401);
  EXPECT_EQ(handler.answer({.method = "GET", .target = "/healthz"}).status, 200);
}

TEST_F(RequestHandler, KeepsBuildingsAsNewVersions) {
  EXPECT_EQ(post("/buildings/lab", kBuilding).body, R"({"building":"lab-2"})");
  EXPECT_EQ(post("/buildings/lab-2", kBuilding).body, R"({"building":"lab-3"})");
  EXPECT_EQ(post("/buildings/hall", kBuilding).status, 201);
  EXPECT_TRUE(fs::exists(root / "buildings/hall.json"));
  std::stringstream old;
  old << std::ifstream(root / "buildings/lab.json").rdbuf();
  EXPECT_EQ(old.str(), kBuilding);
}

TEST_F(RequestHandler, RefusesBuildingsThatCannotBeRead) {
  const HttpReply reply = post("/buildings/lab", R"({"format": "aisle.building", "version": 1, "wall": 3})");
  EXPECT_EQ(reply.status, 422);
  EXPECT_THAT(reply.body, HasSubstr("wall"));
  EXPECT_FALSE(fs::exists(root / "buildings/lab-2.json"));
  EXPECT_EQ(post("/buildings/lab", kBuilding, false).status, 403);
  EXPECT_EQ(post("/buildings/../lab", kBuilding).status, 422);
  EXPECT_EQ(post("/buildings/", kBuilding).status, 422);
}

TEST_F(RequestHandler, HasNoOtherMethods) {
  EXPECT_EQ(handler.answer({.method = "DELETE", .target = "/buildings/lab.json", .knows_token = true}).status,
            405);
  EXPECT_EQ(post("/sessions/run", "x").status, 405);
  EXPECT_EQ(handler.answer({.method = "HEAD", .target = "/healthz"}).status, 200);
}

TEST(WebAddress, PlainNames) {
  for (const char* name : {"a", "lab-2", "Trip_1.x"}) EXPECT_TRUE(is_plain_name(name)) << name;
  for (const char* name : {"", ".", "..", ".x", "a/b", "a b", "a\n", "ä"})
    EXPECT_FALSE(is_plain_name(name)) << name;
  EXPECT_FALSE(is_plain_name(std::string(65, 'a')));
}

}  // namespace
}  // namespace aisle
