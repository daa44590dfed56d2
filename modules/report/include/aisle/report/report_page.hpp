#pragma once

#include <string>
#include <vector>

namespace aisle {

struct ReportFigure {
  std::string name;
  std::string value;
};

struct ReportPicture {
  std::string title;
  std::string svg;      ///< a whole document
  std::string caption;  ///< may be empty
};

/// What a run came to, on one page.
struct ReportPage {
  std::string title;
  std::string summary;  ///< one sentence below the title
  std::vector<std::string> warnings;
  std::vector<ReportFigure> figures;
  std::vector<ReportPicture> pictures;
};

/// The page as one HTML file that needs nothing else: no scripts, pictures inside, readable on a phone, light
/// and dark. Text may hold any characters. Same page, same bytes.
std::string html(const ReportPage& page);

}  // namespace aisle
