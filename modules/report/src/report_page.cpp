#include "aisle/report/report_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace aisle {
namespace {

constexpr std::string_view kStyle = R"(
:root { color-scheme: light dark; --ink: #1f2933; --quiet: #616e7c; --paper: #fff; --line: #d9dee3; --warn: #b44d12; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e4e7eb; --quiet: #9aa5b1; --paper: #14181d; --line: #323f4b; --warn: #f0a05a; }
}
body { margin: 0 auto; max-width: 72rem; padding: 1.5rem; background: var(--paper); color: var(--ink);
  font: 16px/1.5 system-ui, sans-serif; }
h1 { margin: 0; font-size: 1.6rem; }
h2 { margin: 2rem 0 .5rem; font-size: 1.1rem; }
p { margin: .25rem 0; color: var(--quiet); }
ul.warnings { color: var(--warn); padding-left: 1.2rem; }
dl { display: grid; grid-template-columns: repeat(auto-fill, minmax(11rem, 1fr)); gap: .75rem 1.5rem; margin: 1.5rem 0; }
dt { color: var(--quiet); font-size: .85rem; }
dd { margin: 0; font-size: 1.15rem; font-variant-numeric: tabular-nums; }
img { width: 100%; height: auto; background: #fff; border: 1px solid var(--line); border-radius: 4px; }
)";

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

/// RFC 4648 section 4.
std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < 3; ++i)
      group = group << 8 | (i < count ? static_cast<std::uint8_t>(bytes[at + i]) : 0U);
    for (std::size_t i = 0; i < 4; ++i) text += i <= count ? kDigits[group >> (18 - 6 * i) & 63U] : '=';
  }
  return text;
}

/// Embeds each picture as a separate image, so that names inside SVG documents never clash.
std::string picture_html(const ReportPicture& picture) {
  return fmt::format(
      "<h2>{0}</h2>\n{1}<img alt=\"{0}\" src=\"data:image/svg+xml;base64,{2}\">\n", escaped(picture.title),
      picture.caption.empty() ? "" : "<p>" + escaped(picture.caption) + "</p>\n", base64(picture.svg));
}

std::string warnings_html(const std::vector<std::string>& warnings) {
  if (warnings.empty()) return "";
  std::string list = "<ul class=\"warnings\">\n";
  for (const std::string& warning : warnings) list += "<li>" + escaped(warning) + "</li>\n";
  return list + "</ul>\n";
}

std::string figures_html(const std::vector<ReportFigure>& figures) {
  if (figures.empty()) return "";
  std::string list = "<dl>\n";
  for (const ReportFigure& figure : figures) {
    list += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", escaped(figure.name), escaped(figure.value));
  }
  return list + "</dl>\n";
}

}  // namespace

std::string html(const ReportPage& page) {
  std::string text = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n<p>{2}</p>\n",
      escaped(page.title), kStyle, escaped(page.summary));
  text += warnings_html(page.warnings) + figures_html(page.figures);
  for (const ReportPicture& picture : page.pictures) text += picture_html(picture);
  return text + "</body>\n</html>\n";
}

}  // namespace aisle
