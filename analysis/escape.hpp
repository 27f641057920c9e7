#pragma once
#include <string>

namespace brouwer {

// Names come from users' files and may hold anything. Each of these makes a text harmless in one language; bytes
// that are no UTF-8 and control characters become U+FFFD, line breaks and tabs become blanks.

/// Valid UTF-8 on one line, without control characters.
std::string one_line(std::string const& text);

std::string json_string(std::string const& text);  ///< with its quotation marks; line breaks are kept, as \n
std::string xml_text(std::string const& text);     ///< for XML and HTML, in content and in quoted attributes
std::string latex_text(std::string const& text);
std::string markdown_text(std::string const& text);   ///< inside a cell of a table
std::string csv_field(std::string const& text);       ///< RFC 4180
std::string gnuplot_string(std::string const& text);  ///< in single quotes, where gnuplot substitutes nothing

/// A part of a file name: letters, digits, . and -; everything else becomes -; never empty, never begins with . or -.
std::string file_stem(std::string const& text);

}  // namespace brouwer
