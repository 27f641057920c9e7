#include "analysis/files/csv_lines.hpp"

#include <fmt/format.h>

#include <brouwer/error.hpp>
#include <charconv>
#include <cstring>
#include <limits>

namespace brouwer {
namespace {

constexpr std::size_t block = std::size_t{1} << 20;
constexpr std::size_t longest_line = std::size_t{64} << 20;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  auto const first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string_view unquoted(std::string_view field) {
  field = trimmed(field);
  bool const quoted = field.size() >= 2 && field.front() == '"' && field.back() == '"';
  return quoted ? field.substr(1, field.size() - 2) : field;
}

/// Where the field that starts at `from` ends: at the delimiter, or behind the closing quote's delimiter.
std::size_t field_end(std::string_view line, std::size_t from, char delimiter) {
  auto const start = line.find_first_not_of(' ', from);
  if (start != std::string_view::npos && line[start] == '"')
    if (auto const quote = line.find('"', start + 1); quote != std::string_view::npos) from = quote + 1;
  return std::min(line.find(delimiter, from), line.size());
}

void split_at_blanks(std::string_view line, std::vector<std::string_view>& fields) {
  constexpr std::string_view blanks = " \t";
  for (auto from = line.find_first_not_of(blanks); from != std::string_view::npos;) {
    auto const end = std::min(line.find_first_of(blanks, from), line.size());
    fields.push_back(unquoted(line.substr(from, end - from)));
    from = line.find_first_not_of(blanks, end);
  }
}

}  // namespace

CsvLines::CsvLines(std::filesystem::path const& file) : name_(file.string()) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) throw InputError(name_ + ": there is no such file");
  if (std::filesystem::is_directory(file, ignored))
    throw InputError(name_ + ": this is a folder, and a csv file was expected");
  stream_.open(file, std::ios::binary);
  if (!stream_) throw InputError(fmt::format("{}: cannot be opened: {}", name_, std::strerror(errno)));
}

void CsvLines::complain(std::string const& what) const {
  throw InputError(fmt::format("{}:{}: {}", name_, number_, what));
}

/// Keeps what is left of the block, reads another one behind it. False at the end of the file.
bool CsvLines::refill() {
  buffer_.erase(0, position_);
  filled_ -= position_;
  position_ = 0;
  if (filled_ > longest_line) {
    ++number_;
    complain("the line is longer than 64 MiB; is this a csv file?");
  }
  buffer_.resize(filled_ + block);
  stream_.read(buffer_.data() + filled_, static_cast<std::streamsize>(block));
  auto const read = static_cast<std::size_t>(stream_.gcount());
  filled_ += read;
  buffer_.resize(filled_);
  if (stream_.bad()) throw InputError(name_ + ": reading failed");
  return read > 0;
}

bool CsvLines::next_raw(std::string_view& line) {
  std::size_t searched = position_;
  for (;;) {
    auto const end = buffer_.find('\n', searched);
    if (end != std::string_view::npos) {
      line = std::string_view(buffer_).substr(position_, end - position_);
      position_ = end + 1;
      break;
    }
    auto const pending = filled_ - position_;
    if (refill()) {
      searched = pending;
      continue;
    }
    if (pending == 0) return false;
    line = buffer_;
    position_ = filled_;
    break;
  }
  ++number_;
  return true;
}

bool CsvLines::next(std::string_view& line) {
  while (next_raw(line)) {
    if (number_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
    if (line.find('\0') != std::string_view::npos)
      complain("a zero byte: this is no text file (csv in ASCII or UTF-8 was expected)");
    if (line.ends_with('\r')) line.remove_suffix(1);
    auto const content = trimmed(line);
    if (!content.empty() && content.front() != '#') return true;
  }
  return false;
}

Delimiter delimiter_of(std::string_view line) {
  for (auto const candidate : {Delimiter::semicolon, Delimiter::tab, Delimiter::comma})
    if (line.find(static_cast<char>(candidate)) != std::string_view::npos) return candidate;
  return Delimiter::blanks;
}

void split(std::string_view line, Delimiter delimiter, std::vector<std::string_view>& fields) {
  fields.clear();
  if (delimiter == Delimiter::blanks) return split_at_blanks(line, fields);
  for (std::size_t from = 0; from <= line.size();) {
    auto const end = field_end(line, from, static_cast<char>(delimiter));
    fields.push_back(unquoted(line.substr(from, end - from)));
    from = end + 1;
  }
}

bool parse_number(std::string_view field, double& value) {
  if (field.starts_with('+')) field.remove_prefix(1);
  auto const [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error == std::errc::result_out_of_range) value = std::numeric_limits<double>::infinity();
  return error != std::errc::invalid_argument && end == field.data() + field.size();
}

std::string shown(std::string_view field) {
  constexpr std::size_t longest = 40;
  std::string text(field.substr(0, longest));
  for (char& c : text)
    if (static_cast<signed char>(c) < 0x20 || c == 0x7f)
      c = '?';  // bytes from 0x80 on are negative: half a UTF-8 character breaks a line
  return field.size() > longest ? text + "…" : text;
}

}  // namespace brouwer
