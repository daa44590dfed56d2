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
  std::string svg;      ///< a complete document
  std::string caption;  ///< may be empty
};

/// The results of a run on one page.
struct ReportPage {
  std::string title;
  std::string summary;  ///< one sentence below the title
  std::vector<std::string> warnings;
  std::vector<ReportFigure> figures;
  std::vector<ReportPicture> pictures;
};

/// The page as one self-contained HTML file: no scripts, pictures inside, readable on a phone, light and
/// dark. Text may contain any characters. Same page, same bytes.
std::string html(const ReportPage& page);

}  // namespace aisle
