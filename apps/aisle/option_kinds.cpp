#include "option_kinds.hpp"

#include <charconv>

void add_seed(CLI::App& verb, std::uint64_t& seed, const std::string& meaning) {
  const auto read = [&seed](const std::string& text) {
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, seed);
    if (error == std::errc() && rest == end) return;
    throw CLI::ValidationError("--seed",
                               fmt::format("'{}' is not a whole number from 0 to {}", text, UINT64_MAX));
  };
  verb.add_option_function<std::string>("--seed", read, meaning)->type_name("NUMBER");
}
