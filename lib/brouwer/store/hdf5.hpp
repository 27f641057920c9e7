#pragma once
// A thin layer over HDF5's C interface, for the store alone: handles that close themselves, failures as
// exceptions, and the few kinds of attributes and data sets that a unit file is made of.
#include <bit>
#include <cstdint>
#include <filesystem>
#include <hdf5.h>
#include <mutex>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace brouwer::hdf5 {

static_assert(std::endian::native == std::endian::little, "the checksums in unit files are over little-endian numbers");

/// Debian's HDF5 is not thread-safe: whoever uses it holds a Session. While one lives, HDF5 keeps its error
/// stack to itself instead of printing it.
class Session {
 public:
  Session();
  ~Session();
  Session(Session const&) = delete;
  Session& operator=(Session const&) = delete;

 private:
  std::lock_guard<std::mutex> lock_;
  H5E_auto2_t printer_ = nullptr;
  void* printer_data_ = nullptr;
};

/// What went wrong, in HDF5's words or ours; the store adds the file's name and makes a RunError of it.
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// `result` of any HDF5 function. @throws Failure with HDF5's innermost reason where it is negative.
template <class Result>
Result checked(Result result);

/// An HDF5 object of any kind, closed when it goes.
class Handle {
 public:
  explicit Handle(hid_t id) : id_(checked(id)) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~Handle() {
    if (id_ >= 0) H5Idec_ref(id_);
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
};

/// A file, read only and without HDF5's lock, which network file systems and read-only disks refuse.
Handle open_to_read(std::filesystem::path const& file);

// --- attributes: one text or one number ----------------------------------------------------------
void set(hid_t object, char const* name, std::string const& text);
void set(hid_t object, char const* name, std::int64_t number);
void set(hid_t object, char const* name, double number);
bool has(hid_t object, char const* name);
std::string text(hid_t object, char const* name);
std::int64_t integer(hid_t object, char const* name);
double real(hid_t object, char const* name);

// --- data sets: whole arrays, contiguous, with the CRC-32 of their bytes as attribute `crc32` -----
using Extent = std::vector<hsize_t>;

Handle create(hid_t group, std::string const& name, Extent const& extent, std::span<double const> values);
Handle create(hid_t group, std::string const& name, Extent const& extent, std::span<std::int64_t const> values);
/// Texts of one length, filled up with zeros: HDF5 guards those by checksums, unlike texts of variable length.
Handle create(hid_t group, std::string const& name, std::vector<std::string> const& texts);

Handle open(hid_t group, std::string const& name);

/// The shape of a data set.
/// @throws Failure where the file is too short to hold that many elements: a damaged file asks for no memory.
Extent extent(hid_t dataset);

/// Fills `values`, which has as many elements as the data set. @throws Failure where the checksum disagrees.
void read(hid_t dataset, std::span<double> values);
void read(hid_t dataset, std::span<std::int64_t> values);
std::vector<std::string> read_texts(hid_t dataset);

}  // namespace brouwer::hdf5
