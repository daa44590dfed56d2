#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <utility>

#include "aisle/core/angle.hpp"
#include "aisle/core/former_keys.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/core/random.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

struct Inner {
  int tries = 3;
  bool careful = true;
  void describe(FieldList& fields) {
    fields.count("tries", tries, {1, 10}, "how often");
    fields.flag("careful", careful, "slower and surer");
  }
};

struct Params {
  double reach_m = 2;
  double opening_rad = 10 * kDegree;
  Inner inner;
  void describe(FieldList& fields) {
    fields.real("reach_m", reach_m, {0, 5}, "how far");
    fields.angle("opening_deg", opening_rad, {0, 90}, "how wide");
    fields.group("inner", inner);
  }
};

TEST(Parameters, AssignsEveryKindOfFieldByItsDottedKey) {
  Params params;
  FieldList fields = fields_of(params);
  EXPECT_THAT(fields.assign("reach_m", "4.5", {}), IsEmpty());
  EXPECT_THAT(fields.assign("opening_deg", "45", {}), IsEmpty());
  EXPECT_THAT(fields.assign("inner.tries", "7", {}), IsEmpty());
  EXPECT_THAT(fields.assign("inner.careful", "false", {}), IsEmpty());
  EXPECT_DOUBLE_EQ(params.reach_m, 4.5);
  EXPECT_DOUBLE_EQ(params.opening_rad, kPi / 4);
  EXPECT_EQ(params.inner.tries, 7);
  EXPECT_FALSE(params.inner.careful);
}

TEST(Parameters, PrintsValuesInTheUnitOfTheKey) {
  Params params;
  const FieldList fields = fields_of(params);
  EXPECT_EQ(fields.all()[1].key, "opening_deg");
  EXPECT_EQ(fields.all()[1].value_text(), "10");
}

template <class Fields>
concept AllowsALoopOver = requires(Fields&& fields) {
  std::forward<Fields>(fields).all();
};

TEST(Parameters, AListThatIsAboutToGoIsNotLoopedOver) {
  EXPECT_TRUE(AllowsALoopOver<FieldList&>);
  EXPECT_TRUE(AllowsALoopOver<const FieldList&>);
  EXPECT_FALSE(AllowsALoopOver<FieldList>);
}

/// What reading the printed value of a field gives.
template <class AddField>
double read_back(double value, AddField add) {
  FieldList fields;
  add(fields, value);
  const std::string text = fields.all()[0].value_text();
  value = 0;
  return fields.assign("x", text, {}).empty() ? value : NAN;
}

RC_GTEST_PROP(Parameters, ANumberIsPrintedSoThatItReadsBackTheSame, (std::uint64_t seed)) {
  const auto number = std::bit_cast<double>(Random(seed).bits());
  RC_PRE(std::isfinite(number));
  const auto real = [](FieldList& fields, double& x) { fields.real("x", x, {-INFINITY, INFINITY}, ""); };
  RC_ASSERT(read_back(number, real) == number);
}

RC_GTEST_PROP(Parameters, AnAngleIsPrintedSoThatItReadsBackToTheLastBits, (std::uint64_t seed)) {
  const double angle_rad = Random(seed).uniform(0, 2 * kPi);
  const auto angle = [](FieldList& fields, double& x) { fields.angle("x", x, {0, 360}, ""); };
  RC_ASSERT(std::abs(read_back(angle_rad, angle) - angle_rad) <= 4e-16 * angle_rad);
}

TEST(Parameters, DegreesArePrintedWithTheDigitsThatTheyWereWrittenWith) {
  for (int tenths = 1; tenths <= 3600; ++tenths) {
    const std::string text = tenths % 10 == 0
                                 ? std::to_string(tenths / 10)
                                 : std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
    double angle_rad = 0;
    FieldList fields;
    fields.angle("x", angle_rad, {0, 360}, "");
    ASSERT_THAT(fields.assign("x", text, {}), IsEmpty());
    EXPECT_EQ(fields.all()[0].value_text(), text);
  }
}

TEST(Parameters, AFormerKeyIsReadAsThePresentOne) {
  struct Frontiers {
    double uncertain_m = 0.05;
    void describe(FieldList& fields) { fields.real("uncertain_m", uncertain_m, {0, 1}, ""); }
  };
  struct Explorer {
    Frontiers frontiers;
    void describe(FieldList& fields) { fields.group("frontiers", frontiers); }
  } params;
  ASSERT_THAT(fields_of(params).assign("gates.doubt_m", "0.25", {}), IsEmpty());
  EXPECT_EQ(params.frontiers.uncertain_m, 0.25);
  EXPECT_EQ(present_key("inner.tries"), "inner.tries");
  EXPECT_EQ(present_key(""), "");
  EXPECT_EQ(present_key("way_m."), "path_m.");
}

TEST(Parameters, AKeyThatIsBothAFormerAndAPresentOneIsThePresentOne) {
  struct Both {
    double room_m = 1, clearance_m = 1;
    void describe(FieldList& fields) {
      fields.real("room_m", room_m, {0, 9}, "");
      fields.real("clearance_m", clearance_m, {0, 9}, "");
    }
  } params;
  ASSERT_THAT(fields_of(params).assign("room_m", "2", {}), IsEmpty());
  EXPECT_EQ(params.room_m, 2);
  EXPECT_EQ(params.clearance_m, 1);
}

TEST(Parameters, AnUnknownKeyNamesTheNearestOne) {
  Params params;
  const Problems problems = fields_of(params).assign("inner.trys", "1", {"my.yaml", 7, ""});
  ASSERT_THAT(problems, SizeIs(1));
  EXPECT_EQ(to_string(problems[0]), "my.yaml:7: inner.trys: unknown key (nearest known key: inner.tries)");
}

TEST(Parameters, BadValuesNameTheRangeAndLeaveTheFieldAlone) {
  Params params;
  FieldList fields = fields_of(params);
  EXPECT_THAT(to_string(fields.assign("reach_m", "5.1", {})), HasSubstr("5.1 is outside 0 .. 5"));
  EXPECT_THAT(to_string(fields.assign("reach_m", "nan", {})), HasSubstr("not a number"));
  EXPECT_THAT(to_string(fields.assign("reach_m", "3m", {})), HasSubstr("not a number"));
  EXPECT_THAT(to_string(fields.assign("inner.tries", "2.5", {})), HasSubstr("not a whole number"));
  EXPECT_THAT(to_string(fields.assign("inner.careful", "2", {})), HasSubstr("not true or false"));
  EXPECT_DOUBLE_EQ(params.reach_m, 2);
  EXPECT_EQ(params.inner.tries, 3);
}

}  // namespace
}  // namespace aisle
