#include "analysis/files/ensembles_file.hpp"

#include <fmt/format.h>

#include <brouwer/error.hpp>
#include <fstream>
#include <string_view>

#include "analysis/files/csv.hpp"
#include "analysis/files/hdf5_ensembles.hpp"

namespace brouwer {
namespace {

using namespace std::string_view_literals;

/// At least 8 bytes each, or all that the file has.
constexpr std::string_view hdf5_signature = "\x89HDF\r\n\x1a\n"sv;

/// Files that are no text and can be told by how they begin, and what becomes of them.
struct Foreign {
  std::string_view begins;
  char const* advice;
};
constexpr Foreign foreign[] = {
    {"CDF\x01"sv, "a netCDF file of the classic format; 'nccopy -k nc4 OLD NEW' makes one that is HDF5"},
    {"CDF\x02"sv, "a netCDF file of the 64-bit format; 'nccopy -k nc4 OLD NEW' makes one that is HDF5"},
    {"CDF\x05"sv, "a netCDF file of the CDF-5 format; 'nccopy -k nc4 OLD NEW' makes one that is HDF5"},
    {"\x93NUMPY"sv, "a NumPy array; write it with h5py, beside its times, or as csv"},
    {"PK\x03\x04"sv, "a zip archive (or NumPy's npz); expected csv or HDF5"},
    {"\x1f\x8b"sv, "compressed with gzip; unpack it first"},
    {"BZh"sv, "compressed with bzip2; unpack it first"},
    {"\xfd"
     "7zXZ"sv,
     "compressed with xz; unpack it first"},
    {"PAR1"sv, "a Parquet file; expected csv or HDF5"},
    {"SIMPLE  ="sv, "a FITS file; expected csv or HDF5"},
};

std::string bytes_at(std::ifstream& stream, std::streamoff place, std::size_t count) {
  std::string bytes(count, '\0');
  stream.clear();
  stream.seekg(place);
  stream.read(bytes.data(), static_cast<std::streamsize>(count));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
  return bytes;
}

/// HDF5's signature stands at the beginning, or behind a user block of 512, 1024, 2048 … bytes.
bool is_hdf5(std::ifstream& stream) {
  constexpr std::streamoff farthest = 1 << 20;
  for (std::streamoff place = 0; place <= farthest; place = place == 0 ? 512 : 2 * place) {
    auto const bytes = bytes_at(stream, place, hdf5_signature.size());
    if (bytes == hdf5_signature) return true;
    if (bytes.empty()) return false;
  }
  return false;
}

void refuse_foreign(std::ifstream& stream, std::string const& file) {
  auto const bytes = bytes_at(stream, 0, 16);
  for (auto const& [begins, advice] : foreign)
    if (bytes.starts_with(begins)) throw InputError(fmt::format("{}: this is {}", file, advice));
}

void refuse_dataset(FileReading const& reading, std::string const& file) {
  if (!reading.dataset.empty() || !reading.times.empty())
    throw InputError(fmt::format("{}: {} names a data set of an HDF5 file, and this is none", file,
                                 reading.dataset.empty() ? "--times" : "--dataset"));
}

}  // namespace

std::vector<Ensemble> read_ensembles(std::filesystem::path const& file, FileReading const& reading) {
  std::ifstream stream(file, std::ios::binary);
  bool const readable = stream && !std::filesystem::is_directory(file);
  if (readable && is_hdf5(stream)) return read_hdf5(file, reading.dataset, reading.times, reading.values);
  if (readable) refuse_foreign(stream, file.string());
  if (readable) refuse_dataset(reading, file.string());
  return read_csv(file, reading.values);  // which also says why a file cannot be read
}

}  // namespace brouwer
