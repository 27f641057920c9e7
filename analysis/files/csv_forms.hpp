#pragma once
#include <brouwer/store/results.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/files/csv_lines.hpp"
#include "analysis/files/foreign_ensembles.hpp"
#include "analysis/files/from_start.hpp"

namespace brouwer {

using CsvFields = std::vector<std::string_view>;

/// The names of the columns, in lower case, and how they are separated. Empty names: there was no header.
struct CsvHeader {
  std::vector<std::string> names;
  Delimiter delimiter = Delimiter::comma;

  std::optional<std::size_t> find(std::string_view name) const;
};

/// The finite number in a column, or a complaint with line, column and what stood there.
double number_at(CsvLines const& lines, CsvHeader const& header, CsvFields const& fields, std::size_t column);

/// The same for a time, which is not negative either.
double time_at(CsvLines const& lines, CsvHeader const& header, CsvFields const& fields, std::size_t column);

/// Complains unless a line has `count` fields.
void require_fields(CsvLines const& lines, CsvFields const& fields, std::size_t count);

/// Complains that an error at time 0 is not zero.
void require_zero_start(CsvLines const& lines, double error);

/// Reads the lines behind the header.
std::vector<Ensemble> read_long_form(CsvLines& lines, CsvHeader const& header, FileValues values);

/// @param first  the fields of the first line of data, which is what the caller has read last; empty if that was a
/// header
Ensemble read_wide_form(CsvLines& lines, CsvHeader const& header, CsvFields first, FileValues values);

}  // namespace brouwer
