// Door frames, corners and posters in an image: 03_find_vertical_lines IMAGE
#include <aisle/formats/images/image_file.hpp>
#include <aisle/vision/lines/vertical_lines.hpp>
#include <iostream>

int main(int argc, char** argv) {
  if (argc != 2) return std::cerr << "03_find_vertical_lines IMAGE\n", 2;

  const auto image = aisle::read_image(argv[1]);
  if (!image) return std::cerr << to_string(image.problems()) << '\n', 2;

  aisle::VerticalLineDetector detector;
  for (const aisle::VerticalLine& line : detector.detect(to_grey(*image)))
    std::cout << "from " << line.top_px.transpose() << " to " << line.bottom_px.transpose() << ", "
              << (line.contrast > 0 ? "right" : "left") << " side brighter\n";
}
