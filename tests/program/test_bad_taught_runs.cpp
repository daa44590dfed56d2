/// What the learning verbs refuse, and how: one line per problem that names the file and the key, and no
/// files left behind.

#include <gmock/gmock.h>

#include "aisle/formats/sessions/session_writer.hpp"
#include "workplace.hpp"

namespace aisle {
namespace {

using testing::IsEmpty;
using testing::StartsWith;

std::string with(const std::string& text, const std::string& part, const std::string& other) {
  const std::size_t found = text.find(part);
  EXPECT_NE(found, std::string::npos) << part;
  return found == std::string::npos ? text : text.substr(0, found) + other + text.substr(found + part.size());
}

class BadTaughtRuns : public Workplace {
 protected:
  void SetUp() override { file("keys.txt", "0-4 up\n"); }

  void TearDown() override { EXPECT_THAT(names_in(at("out")), IsEmpty()); }

  /// A few metres of a corridor.
  void teach(const std::string& out, const std::string& world = "l-corridor") const {
    const ProgramRun run =
        run_aisle({"teach", world, "--keys", at("keys.txt"), "--route", "main", "--out", at(out), "--json"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }

  void teach_and_learn() const {
    teach("taught");
    ASSERT_EQ(run_aisle({"learn", at("taught"), "--out", at("learned")}).exit_code, 0);
  }

  std::string building() const { return at("learned/building.json"); }

  ProgramRun learn(const std::string& session) const {
    return run_aisle({"learn", session, "--out", at("out"), "--json"});
  }

  ProgramRun navigate(const std::string& building, const Arguments& more = {}) const {
    Arguments arguments = {"navigate", building, "--world", "l-corridor", "--out", at("out"), "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_aisle(arguments);
  }

  ProgramRun refine(const std::string& building, const std::string& session) const {
    return run_aisle({"refine", building, session, "--out", at("out"), "--json"});
  }
};

TEST_F(BadTaughtRuns, OnlySectionsAreLearnedFromSeveralSessions) {
  const ProgramRun run = run_aisle({"learn", at("one"), at("two"), "--out", at("out"), "--json"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, testing::HasSubstr("two: is one session too many"));
}

TEST_F(BadTaughtRuns, NamesThatNoRouteCanHaveAreRefusedBeforeTheDrive) {
  for (const std::string& name :
       {std::string(), std::string(201, 'a'), std::string("a/b"), std::string("a\nb")}) {
    EXPECT_THAT(run_aisle({"teach", "l-corridor", "--route", name, "--out", at("out"), "--json"}),
                IsRefused("--route: "))
        << name;
  }
}

TEST_F(BadTaughtRuns, ARouteThatAScriptedPersonDoesNotKnowIsRefusedWithThoseThatItKnows) {
  EXPECT_THAT(
      run_aisle({"teach", "laboratory", "--method", "rooms", "--route", "garden", "--operator", "scripted",
                 "--out", at("out"), "--json"}),
      IsRefused("'garden', which a scripted person could drive; there are: parking frame, dead end, "));
}

TEST_F(BadTaughtRuns, ThePatternOfViewsIsDrivenAboutTaughtPlacesOnly) {
  EXPECT_THAT(run_aisle({"teach", "laboratory", "--views", "pattern", "--out", at("out"), "--json"}),
              IsRefused("--views: the pattern needs --method rooms"));
  EXPECT_THAT(run_aisle({"teach", "laboratory", "--method", "rooms", "--route", "dead end", "--operator",
                         "scripted", "--views", "pattern", "--out", at("out"), "--json"}),
              IsRefused("--views: only a scripted person can drive the pattern"));
}

TEST_F(BadTaughtRuns, UnknownMethodsAreRefused) {
  const char* what = "'owls' is unknown; there are: landmarks, sections, rooms";
  EXPECT_THAT(run_aisle({"teach", "l-corridor", "--method", "owls", "--out", at("out"), "--json"}),
              IsRefused(what));
  EXPECT_THAT(run_aisle({"learn", at("none"), "--method", "owls", "--out", at("out"), "--json"}),
              IsRefused(what));
  EXPECT_THAT(navigate(at("none"), {"--method", "owls"}), IsRefused(what));
  EXPECT_THAT(run_aisle({"trial", "owls", "--json"}), IsRefused("'owls' is none of landmarks, sections"));
}

TEST_F(BadTaughtRuns, SeedsThatAreNoneAreRefused) {
  for (const char* seeds :
       {"", "one", "2..1", "1..", "..2", "-1..2", "1...3", "0..99999999", "1..2..3", "1.5"}) {
    EXPECT_THAT(run_aisle({"trial", "landmarks", "--seeds", seeds, "--json"}), IsRefused("--seeds")) << seeds;
  }
}

TEST_F(BadTaughtRuns, FilesThatAreMissingAreRefusedByName) {
  EXPECT_THAT(learn(at("none")), IsRefused(at("none")));
  EXPECT_THAT(navigate(at("none.json")), IsRefused(at("none.json") + ": no such file"));
  EXPECT_THAT(refine(at("none.json"), at("none")), IsRefused(at("none.json") + ": no such file"));
  EXPECT_THAT(run_aisle({"trial", "landmarks", "--world", at("none.yaml"), "--json"}),
              IsRefused(at("none.yaml")));
  EXPECT_THAT(run_aisle({"teach", at("none.yaml"), "--out", at("out"), "--json"}),
              IsRefused(at("none.yaml")));
}

TEST_F(BadTaughtRuns, ARouteThroughARoomIsNotTaughtWithACameraThatLooksUp) {
  const std::string vehicle = file(
      "up.yaml", with(read_bytes(AISLE_SOURCE_DIR "/vehicles/alv.yaml"), "tilt_deg: 38", "tilt_deg: -30"));
  EXPECT_THAT(run_aisle({"teach", "laboratory", "--method", "rooms", "--route", "instruments", "--vehicle",
                         vehicle, "--operator", "scripted", "--out", at("out"), "--json"}),
              IsRefused(vehicle + ": cameras.top: does not see the floor"));
}

TEST_F(BadTaughtRuns, SessionsFromWhichNothingCanBeLearnedAreRefused) {
  const auto drive = [&](const std::string& out, const Arguments& more) {
    Arguments arguments = {"drive",  "mini-corridor", "--vehicle", "mini",
                           "--keys", at("keys.txt"),  "--out",     at(out)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_aisle(arguments);
  };
  ASSERT_EQ(drive("blind", {"--no-images"}).exit_code, 0);
  EXPECT_THAT(learn(at("blind")), IsRefused(at("blind") + ": has no images of the camera front"));

  const std::string dark = file("dark.yaml",
                                "format: aisle.scenario\nversion: 1\nname: dark\nevents:\n"
                                "  - from_s: 0\n    for_s: 60\n    camera: {fault: dark}\n");
  ASSERT_EQ(drive("black", {"--faults", dark}).exit_code, 0);
  EXPECT_THAT(learn(at("black")), IsRefused(at("black") + ": the run shows no landmarks"));

  ASSERT_THAT(SessionWriter::create(at("empty"), false)->close(), IsEmpty());
  EXPECT_THAT(learn(at("empty")), IsRefused(at("empty")));
}

TEST_F(BadTaughtRuns, BuildingsAndRoutesThatCannotBeDrivenAreRefused) {
  teach_and_learn();
  const std::string text = read_bytes(building());
  EXPECT_THAT(navigate(file("newer.json", with(text, "\"version\": 3", "\"version\": 4"))),
              IsRefused(at("newer.json") + ": version"));
  EXPECT_THAT(refine(at("newer.json"), at("taught")), IsRefused(at("newer.json") + ": version"));
  EXPECT_THAT(navigate(file("half.json", text.substr(0, text.size() / 2))), IsRefused(at("half.json")));
  EXPECT_THAT(navigate(building(), {"--route", "attic"}),
              IsRefused(building() + ": route: 'attic' is unknown; the building has: main"));
  EXPECT_THAT(navigate(building(), {"--vehicle", "mini"}), IsRefused("cameras.corridor: is missing"));
  const std::string alv = read_bytes(AISLE_SOURCE_DIR "/vehicles/alv.yaml");
  EXPECT_THAT(navigate(building(), {"--vehicle", file("alv.yaml", with(alv, "fx_px: 460", "fx_px: 470"))}),
              IsRefused("corridor"));
  EXPECT_THAT(run_aisle({"navigate", building(), "--world", "attic", "--out", at("out"), "--json"}),
              IsRefused("attic"));
  EXPECT_THAT(navigate(building(), {"--speed", "-1"}), IsRefused("--speed"));
}

TEST_F(BadTaughtRuns, SessionsThatAreNotOfTheBuildingAreRefused) {
  teach_and_learn();
  teach("other", "c98-corridor");
  EXPECT_THAT(refine(building(), at("other")), IsRefused(at("other") + ": shows other landmarks"));
  ASSERT_EQ(run_aisle({"drive", "mini-corridor", "--vehicle", "mini", "--keys", at("keys.txt"), "--out",
                       at("mini")})
                .exit_code,
            0);
  const ProgramRun run = refine(building(), at("mini"));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, StartsWith(at("mini") + ": cameras.front: is not 'corridor'"));
}

TEST_F(BadTaughtRuns, ResultsThatAreThereAreNotReplacedUnlessAskedFor) {
  teach_and_learn();
  const std::string before = read_bytes(building());
  for (const Arguments& again :
       {Arguments{"learn", at("taught")}, Arguments{"refine", building(), at("taught")}}) {
    Arguments arguments = again;
    arguments.insert(arguments.end(), {"--out", at("learned"), "--json"});
    const ProgramRun run = run_aisle(arguments);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_THAT(run.err, StartsWith(building() + ": exists already; --force replaces it\n"));
  }
  EXPECT_THAT(run_aisle({"teach", "l-corridor", "--keys", at("keys.txt"), "--out", at("taught"), "--json"}),
              IsRefused(at("taught")));
  EXPECT_EQ(read_bytes(building()), before);
  EXPECT_EQ(run_aisle({"learn", at("taught"), "--out", at("learned"), "--force"}).exit_code, 0);
}

}  // namespace
}  // namespace aisle
