#include <cairo-pdf.h>
#include <gmock/gmock.h>

#include "aisle/formats/images/plan_drawing.hpp"
#include "aisle/formats/whole_file.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

constexpr DrawingScale kTenCentimetres{.cell_m = 0.1};

std::string why(const Result<PlanReading>& read) {
  return read.ok() ? "" : to_string(read.problems());
}

/// A room of 6 x 4 m whose walls are the border, and a pillar in its middle.
void expect_room(const PlanReading& read) {
  const FloorPlan& plan = read.plan;
  const int middle_x = plan.width / 2, middle_y = plan.height / 2;
  EXPECT_NEAR(plan.width, 60, 2);
  EXPECT_NEAR(plan.height, 40, 2);
  int solid = 0;
  for (int x = 0; x < plan.width; ++x) solid += plan.is_solid(x, middle_y - 10);
  EXPECT_GE(solid, 2);
  EXPECT_LE(solid, 6) << "two walls of a cell or two";
  EXPECT_FALSE(plan.is_solid(middle_x - 10, middle_y));
  bool has_pillar = false;
  for (int x = middle_x - 4; x < middle_x + 4; ++x) has_pillar = has_pillar || plan.is_solid(x, middle_y);
  EXPECT_TRUE(has_pillar);
}

std::string svg_room(const std::string& size) {
  return "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" " + size +
         " viewBox=\"0 0 600 400\">"
         "<rect x=\"2\" y=\"2\" width=\"596\" height=\"396\" fill=\"none\" stroke=\"black\" "
         "stroke-width=\"4\"/>"
         "<circle cx=\"300\" cy=\"200\" r=\"20\"/></svg>";
}

TEST(PlanDrawing, AnSvgHasItsScaleFromWidthAndViewBox) {
  const auto read =
      parse_plan_drawing(svg_room("width=\"6000mm\" height=\"4000mm\""), "room.svg", kTenCentimetres);
  ASSERT_TRUE(read.ok()) << why(read);
  expect_room(*read);
}

TEST(PlanDrawing, WithoutAScaleTheUserIsAskedForOne) {
  EXPECT_THAT(why(parse_plan_drawing(svg_room(""), "room.svg", kTenCentimetres)),
              HasSubstr("room.svg: does not say how large it is: --scale-by"));
  EXPECT_THAT(why(parse_plan_drawing(svg_room("width=\"60mm\""), "room.svg", kTenCentimetres)),
              HasSubstr("the size of paper"));
  const auto read = parse_plan_drawing(svg_room(""), "room.svg", {.cell_m = 0.1, .unit_m = 0.01});
  ASSERT_TRUE(read.ok()) << why(read);
  expect_room(*read);
  EXPECT_THAT(why(parse_plan_drawing(svg_room(""), "room.svg", {.cell_m = 0.001, .unit_m = 0.01})),
              HasSubstr("makes 6000 x 4000 cells"));
}

TEST(PlanDrawing, ADxfIsReadWithBlocksAndUnits) {
  const std::string dxf =
      *read_whole_file(std::filesystem::path(AISLE_SOURCE_DIR) / "tests/fuzz/corpus/plan_drawing/room.dxf");
  const auto read = parse_plan_drawing(dxf, "room.dxf", kTenCentimetres);
  ASSERT_TRUE(read.ok()) << why(read);
  expect_room(*read);
  EXPECT_EQ(to_string(read->warnings),
            "room.dxf: is read without 1 TEXT\nroom.dxf: is read without 1 quarter circles: arcs of doors");
}

TEST(PlanDrawing, ADxfOfBlocksInBlocksEnds) {
  std::string dxf = "0\nSECTION\n2\nBLOCKS\n";
  for (int level = 0; level < 8; ++level) {
    dxf += "0\nBLOCK\n2\nB" + std::to_string(level) + "\n";
    for (int i = 0; i < 30; ++i) dxf += "0\nINSERT\n2\nB" + std::to_string(level + 1) + "\n";
    dxf += "0\nENDBLK\n";
  }
  dxf += "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nINSERT\n2\nB0\n0\nENDSEC\n0\nEOF\n";
  EXPECT_THAT(why(parse_plan_drawing(dxf, "bomb.dxf", kTenCentimetres)), HasSubstr("bomb.dxf: has "));
}

TEST(PlanDrawing, WhatIsNoDxfIsNamedWithItsLine) {
  EXPECT_EQ(why(parse_plan_drawing("0\nSECTION\n2\nENTITIES\nx\ny\n", "a.dxf", kTenCentimetres)),
            "a.dxf:5: 'x' is not a group code");
}

std::string pdf_room() {
  std::string bytes;
  const auto write = [](void* to, const unsigned char* data, unsigned size) {
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(data), size);
    return CAIRO_STATUS_SUCCESS;
  };
  cairo_surface_t* surface = cairo_pdf_surface_create_for_stream(write, &bytes, 600, 400);
  cairo_t* canvas = cairo_create(surface);
  cairo_set_line_width(canvas, 4);
  cairo_rectangle(canvas, 2, 2, 596, 396);
  cairo_stroke(canvas);
  cairo_arc(canvas, 300, 200, 20, 0, 7);
  cairo_fill(canvas);
  cairo_show_page(canvas);
  cairo_show_page(canvas);
  cairo_destroy(canvas);
  cairo_surface_destroy(surface);
  return bytes;
}

TEST(PlanDrawing, ThePageOfAPdfIsReadByItsPoints) {
  EXPECT_THAT(why(parse_plan_drawing(pdf_room(), "room.pdf", kTenCentimetres)), HasSubstr("--scale-by"));
  const auto read = parse_plan_drawing(pdf_room(), "room.pdf", {.cell_m = 0.1, .unit_m = 0.01});
  ASSERT_TRUE(read.ok()) << why(read);
  expect_room(*read);
  EXPECT_EQ(to_string(read->warnings), "room.pdf: has 2 pages; the first is read");
}

TEST(PlanDrawing, DamagedDrawingsAreRefused) {
  EXPECT_THAT(why(parse_plan_drawing("%PDF-1.4\nnothing", "a.pdf", kTenCentimetres)),
              HasSubstr("a.pdf: is not a PDF"));
  EXPECT_THAT(why(parse_plan_drawing("<svg width=\"5m\"", "a.svg", kTenCentimetres)),
              HasSubstr("a.svg: is not an SVG"));
  EXPECT_THAT(why(parse_plan_drawing("hello", "a", kTenCentimetres)), HasSubstr("is not an SVG, PDF or DXF"));
}

}  // namespace
}  // namespace aisle
