#include "analysis/escape.hpp"

#include <algorithm>
#include <cctype>
#include <map>

namespace brouwer {
namespace {

constexpr char const* replacement = "\xEF\xBF\xBD";  // U+FFFD

using Byte = unsigned char;

bool is_control(Byte c) { return c < 0x20 || c == 0x7F; }

/// Number of bytes of the well-formed UTF-8 sequence that begins at i; 0 if there is none (Unicode 15, table 3-7).
std::size_t sequence_length(std::string const& text, std::size_t i) {
  auto const byte = [&](std::size_t k) { return k < text.size() ? static_cast<Byte>(text[k]) : Byte{0}; };
  auto const between = [&](std::size_t k, int low, int high) { return byte(k) >= low && byte(k) <= high; };
  Byte const first = byte(i);
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return between(i + 1, 0x80, 0xBF) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF) {
    int const low = first == 0xE0 ? 0xA0 : 0x80, high = first == 0xED ? 0x9F : 0xBF;
    return between(i + 1, low, high) && between(i + 2, 0x80, 0xBF) ? 3 : 0;
  }
  if (first >= 0xF0 && first <= 0xF4) {
    int const low = first == 0xF0 ? 0x90 : 0x80, high = first == 0xF4 ? 0x8F : 0xBF;
    return between(i + 1, low, high) && between(i + 2, 0x80, 0xBF) && between(i + 3, 0x80, 0xBF) ? 4 : 0;
  }
  return 0;
}

/// U+0080 … U+009F, and U+FFFE, U+FFFF, which XML does not allow.
bool is_unwelcome(std::string const& sequence) {
  bool const c1_control = sequence.size() == 2 && sequence[0] == '\xC2' && static_cast<Byte>(sequence[1]) < 0xA0;
  return c1_control || sequence == "\xEF\xBF\xBE" || sequence == "\xEF\xBF\xBF";
}

std::string valid_utf8(std::string const& text) {
  std::string valid;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t const length = sequence_length(text, i);
    std::string const sequence = text.substr(i, std::max<std::size_t>(length, 1));
    bool const blank = sequence == "\n" || sequence == "\t" || sequence == "\r";
    bool const bad = length == 0 || is_unwelcome(sequence) || (is_control(static_cast<Byte>(sequence[0])) && !blank);
    valid += bad ? replacement : sequence;
    i += sequence.size();
  }
  return valid;
}

std::string substituted(std::string const& text, std::map<char, std::string> const& by) {
  std::string result;
  for (char const c : text) {
    auto const found = by.find(c);
    if (found == by.end())
      result += c;
    else
      result += found->second;
  }
  return result;
}

}  // namespace

std::string one_line(std::string const& text) {
  return substituted(valid_utf8(text), {{'\n', " "}, {'\t', " "}, {'\r', " "}});
}

std::string json_string(std::string const& text) {
  static std::map<char, std::string> const escapes = {
      {'"', "\\\""}, {'\\', "\\\\"}, {'\n', "\\n"}, {'\t', "\\t"}, {'\r', "\\r"}};
  return '"' + substituted(valid_utf8(text), escapes) + '"';
}

std::string xml_text(std::string const& text) {
  static std::map<char, std::string> const escapes = {{'&', "&amp;"},  {'<', "&lt;"},   {'>', "&gt;"},
                                                      {'"', "&quot;"}, {'\'', "&#39;"}, {'\r', " "}};
  return substituted(valid_utf8(text), escapes);
}

std::string latex_text(std::string const& text) {
  static std::map<char, std::string> const escapes = {{'\\', "\\textbackslash{}"},
                                                      {'{', "\\{"},
                                                      {'}', "\\}"},
                                                      {'$', "\\$"},
                                                      {'&', "\\&"},
                                                      {'#', "\\#"},
                                                      {'%', "\\%"},
                                                      {'_', "\\_"},
                                                      {'^', "\\textasciicircum{}"},
                                                      {'~', "\\textasciitilde{}"},
                                                      {'[', "{[}"},
                                                      {']', "{]}"},  // no optional argument of the \\ before
                                                      {'<', "\\textless{}"},
                                                      {'>', "\\textgreater{}"},
                                                      {'|', "\\textbar{}"},
                                                      {'*', "{*}"},
                                                      {'"', "{''}"}};
  return substituted(one_line(text), escapes);
}

std::string markdown_text(std::string const& text) {
  static std::map<char, std::string> const escapes = {{'|', "\\|"},  {'\\', "\\\\"}, {'*', "\\*"}, {'_', "\\_"},
                                                      {'`', "\\`"},  {'[', "\\["},   {']', "\\]"}, {'<', "&lt;"},
                                                      {'>', "&gt;"}, {'&', "&amp;"}};
  return substituted(one_line(text), escapes);
}

std::string csv_field(std::string const& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  return '"' + substituted(text, {{'"', "\"\""}}) + '"';
}

std::string gnuplot_string(std::string const& text) {
  return '\'' + substituted(one_line(text), {{'\'', "''"}}) + '\'';
}

std::string file_stem(std::string const& text) {
  std::string stem;
  for (char const c : text) stem += std::isalnum(static_cast<Byte>(c)) != 0 || c == '.' ? c : '-';
  auto const begin = stem.find_first_not_of(".-");
  return begin == std::string::npos ? "quantity" : stem.substr(begin, 80);
}

}  // namespace brouwer
