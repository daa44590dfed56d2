#include "manual.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "version.hpp"

namespace {

std::vector<const CLI::App*> verbs_below(const CLI::App& verb) {
  return verb.get_subcommands([](const CLI::App*) { return true; });
}

/// Text as roff takes it: a backslash and a hyphen are themselves, and no line begins with a command.
std::string roff(const std::string& text) {
  std::string escaped;
  for (const char letter : text) {
    if (letter == '\\')
      escaped += "\\e";
    else if (letter == '-')
      escaped += "\\-";
    else if ((letter == '.' || letter == '\'') && (escaped.empty() || escaped.back() == '\n'))
      escaped += std::string("\\&") + letter;
    else
      escaped += letter;
  }
  return escaped;
}

/// "aisle sim log"
std::string full_name(const CLI::App& verb) {
  return verb.get_parent() == nullptr ? verb.get_name()
                                      : full_name(*verb.get_parent()) + " " + verb.get_name();
}

std::string synopsis_of(const CLI::App& verb) {
  std::string text = fmt::format("\\fB{}\\fR", roff(full_name(verb)));
  for (const CLI::Option* option : verb.get_options()) {
    if (!option->get_positional()) continue;
    const std::string word = fmt::format("\\fI{}\\fR", roff(option->get_name(true)));
    text += option->get_required() ? " " + word : " [" + word + "]";
  }
  if (!verbs_below(verb).empty()) text += " \\fIVERB\\fR";
  return text + " [\\fIOPTIONS\\fR]\n";
}

/// An indented paragraph with what it is about in front.
std::string entry(const std::string& tag, const std::string& text) {
  return fmt::format(".TP\n{}\n{}\n", tag, roff(text));
}

std::string options_text(const CLI::App& verb) {
  std::string text;
  for (const CLI::Option* option : verb.get_options()) {
    const bool takes_value = option->get_items_expected_max() > 0;
    text += entry(fmt::format("\\fB{}\\fR{}", roff(option->get_name(option->get_positional(), true)),
                              takes_value ? fmt::format(" \\fI{}\\fR", roff(option->get_type_name())) : ""),
                  option->get_description());
  }
  return text;
}

std::string verbs_text(const CLI::App& verb, const std::string& reference) {
  std::string text;
  for (const CLI::App* below : verbs_below(verb))
    text += entry(fmt::format("\\fB{}{}\\fR", roff(reference), roff(below->get_name())),
                  below->get_description());
  return text;
}

std::string heading(const std::string& name, const std::string& meaning) {
  return fmt::format(".TH {} 1 \"\" \"aisle {}\" \"User Commands\"\n.SH NAME\n{} \\- {}\n", name, release(),
                     roff(name), roff(meaning));
}

/// What stands below the options: a line that ends in a colon is a heading, the rest stays in its lines.
std::string footer_text(const CLI::App& verb) {
  std::string text;
  std::istringstream footer(verb.get_footer());
  for (std::string line; std::getline(footer, line);) {
    const bool is_heading = line.ends_with(':') && !line.starts_with(' ');
    if (is_heading && !text.empty()) text += ".fi\n";
    if (is_heading) {
      line.pop_back();
      std::transform(line.begin(), line.end(), line.begin(), [](unsigned char c) { return std::toupper(c); });
      text += fmt::format(".SH {}\n.nf\n", roff(line));
    } else {
      text += roff(line) + "\n";
    }
  }
  return text.empty() ? text : text + ".fi\n";
}

/// One verb and all below it, each with a synopsis and its options.
std::string verb_page(const CLI::App& verb) {
  std::string text = heading("aisle-" + verb.get_name(), verb.get_description());
  text += ".SH SYNOPSIS\n" + synopsis_of(verb);
  if (!verbs_below(verb).empty()) text += ".SH VERBS\n" + verbs_text(verb, "");
  text += ".SH OPTIONS\n" + options_text(verb);
  for (const CLI::App* below : verbs_below(verb))
    text += fmt::format(".SH {}\n{}\n.PP\n{}{}", roff(full_name(*below)), roff(below->get_description()),
                        synopsis_of(*below), options_text(*below));
  return text + footer_text(verb) + ".SH SEE ALSO\n\\fBaisle\\fR(1)\n";
}

std::string program_page(const CLI::App& program) {
  return heading("aisle", program.get_description()) + ".SH SYNOPSIS\n" + synopsis_of(program) +
         ".SH VERBS\nEach has a page of its own.\n" + verbs_text(program, "aisle-") + ".SH OPTIONS\n" +
         options_text(program) + footer_text(program);
}

}  // namespace

std::map<std::string, std::string> manual_pages(const CLI::App& program) {
  std::map<std::string, std::string> pages{{"aisle.1", program_page(program)}};
  for (const CLI::App* verb : verbs_below(program))
    pages.emplace("aisle-" + verb->get_name() + ".1", verb_page(*verb));
  return pages;
}
