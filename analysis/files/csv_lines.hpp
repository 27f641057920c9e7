#pragma once
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace brouwer {

/// The lines of a text file that carry data: without comments (#), blank lines, a byte order mark and line ends (\n,
/// \r\n). Streams: memory holds one block, and one line where that is longer. Throws InputError with file:line for what
/// is no text file, cannot be read or has lines of more than 64 MiB.
class CsvLines {
 public:
  explicit CsvLines(std::filesystem::path const& file);

  /// Moves to the next line that carries data; false at the end of the file. `line` is valid until the next call.
  bool next(std::string_view& line);

  std::int64_t number() const { return number_; }  ///< of the line given last, from 1
  std::string const& file() const { return name_; }

  /// Complains about the line given last: "errors.csv:12: …".
  [[noreturn]] void complain(std::string const& what) const;

 private:
  bool next_raw(std::string_view& line);
  bool refill();

  std::string name_;
  std::ifstream stream_;
  std::string buffer_;
  std::size_t position_ = 0, filled_ = 0;
  std::int64_t number_ = 0;
};

/// How fields are separated: one comma, semicolon or tab, or any blanks.
enum class Delimiter : char { comma = ',', semicolon = ';', tab = '\t', blanks = ' ' };

/// The first of semicolon, tab, comma that the line contains (numbers may hold commas in semicolon files); else blanks.
Delimiter delimiter_of(std::string_view line);

/// Fields of a line, without the blanks and the pair of double quotes around them; `fields` is reused.
void split(std::string_view line, Delimiter delimiter, std::vector<std::string_view>& fields);

/// Is the whole field a number in C's notation (1, −2.5, 1e-17; also inf and nan)? Then it is in `value`, and ±∞
/// or 0 where it exceeds double's range.
bool parse_number(std::string_view field, double& value);

/// A field as it may be shown in a message: at most 40 bytes; what is not printable ASCII becomes ?.
std::string shown(std::string_view field);

}  // namespace brouwer
