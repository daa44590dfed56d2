#include "web_address.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>
#include <utility>

namespace aisle {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kNameMax = 64;

constexpr std::array<std::pair<std::string_view, std::string_view>, 14> kMediaTypes{{
    {".html", "text/html; charset=utf-8"},
    {".js", "text/javascript; charset=utf-8"},
    {".mjs", "text/javascript; charset=utf-8"},
    {".css", "text/css; charset=utf-8"},
    {".json", "application/json"},
    {".webmanifest", "application/manifest+json"},
    {".svg", "image/svg+xml"},
    {".png", "image/png"},
    {".jpg", "image/jpeg"},
    {".ico", "image/x-icon"},
    {".woff2", "font/woff2"},
    {".wasm", "application/wasm"},
    {".yaml", "text/plain; charset=utf-8"},
    {".txt", "text/plain; charset=utf-8"},
}};

bool is_safe_part(std::string_view part) {
  const auto is_odd = [](unsigned char c) { return c < 0x20 || c == 0x7f || c == '\\'; };
  return !part.empty() && part.front() != '.' && std::none_of(part.begin(), part.end(), is_odd);
}

bool is_within(const fs::path& file, const fs::path& folder) {
  const auto [end, at] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return end == folder.end() && at != file.end();
}

}  // namespace

std::string_view path_of(std::string_view target) {
  return target.substr(0, target.find_first_of("?#"));
}

std::string query_value(std::string_view target, std::string_view key) {
  const std::size_t question = target.find('?');
  std::string_view rest = question == std::string_view::npos ? "" : target.substr(question + 1);
  while (!rest.empty()) {
    const std::string_view pair = rest.substr(0, rest.find('&'));
    rest.remove_prefix(std::min(rest.size(), pair.size() + 1));
    if (pair.size() > key.size() && pair.starts_with(key) && pair[key.size()] == '=')
      return percent_decoded(pair.substr(key.size() + 1)).value_or("");
  }
  return {};
}

std::optional<std::string> percent_decoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      decoded += text[i];
      continue;
    }
    unsigned value = 0;
    const char* digits = text.data() + i + 1;
    if (i + 2 >= text.size() || std::from_chars(digits, digits + 2, value, 16).ptr != digits + 2)
      return std::nullopt;
    decoded += static_cast<char>(value);
    i += 2;
  }
  return decoded;
}

std::optional<fs::path> file_below(const fs::path& folder, std::string_view path) {
  const auto decoded = percent_decoded(path);
  if (!decoded) return std::nullopt;
  fs::path file = folder;
  std::string_view rest = *decoded;
  while (!rest.empty()) {
    const std::string_view part = rest.substr(0, rest.find('/'));
    if (!is_safe_part(part)) return std::nullopt;
    file /= part;
    rest.remove_prefix(std::min(rest.size(), part.size() + 1));
  }
  std::error_code error;
  const fs::path real_folder = fs::weakly_canonical(folder, error);
  const fs::path real_file = fs::weakly_canonical(file, error);
  if (error || !is_within(real_file, real_folder)) return std::nullopt;
  return real_file;
}

bool is_plain_name(std::string_view name) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
  };
  return !name.empty() && name.size() <= kNameMax && name.front() != '.' &&
         std::all_of(name.begin(), name.end(), is_plain);
}

std::string media_type(const fs::path& file) {
  const std::string ending = file.extension().string();
  const auto known = std::find_if(kMediaTypes.begin(), kMediaTypes.end(),
                                  [&](const auto& type) { return type.first == ending; });
  return std::string(known == kMediaTypes.end() ? "application/octet-stream" : known->second);
}

}  // namespace aisle
