#include <brouwer/store/hdf5.hpp>

#include <algorithm>
#include <zlib.h>

namespace brouwer::hdf5 {
namespace {

std::mutex one_user_at_a_time;

template <class T>
struct Types;
template <>
struct Types<double> {
  static hid_t in_file() { return H5T_IEEE_F64LE; }
  static hid_t in_memory() { return H5T_NATIVE_DOUBLE; }
};
template <>
struct Types<std::int64_t> {
  static hid_t in_file() { return H5T_STD_I64LE; }
  static hid_t in_memory() { return H5T_NATIVE_INT64; }
};

/// Text of `size` bytes. HDF5 knows no empty ones: "" is one zero byte.
Handle text_type(std::size_t size) {
  Handle type(H5Tcopy(H5T_C_S1));
  checked(H5Tset_size(type, std::max<std::size_t>(size, 1)));
  checked(H5Tset_strpad(type, H5T_STR_NULLPAD));
  checked(H5Tset_cset(type, H5T_CSET_UTF8));
  return type;
}

/// CRC-32 as in zlib, PNG and Python: `zlib.crc32(dataset[...].tobytes())`.
std::int64_t crc32_of(void const* data, std::size_t bytes) {
  return static_cast<std::int64_t>(::crc32_z(0, static_cast<Bytef const*>(data), bytes));
}

Handle make(hid_t group, std::string const& name, Extent const& extent, hid_t file_type, hid_t memory_type,
            void const* data, std::size_t bytes) {
  Handle const space(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr));
  Handle const properties(H5Pcreate(H5P_DATASET_CREATE));
  checked(H5Pset_obj_track_times(properties, false));
  checked(H5Pset_attr_creation_order(properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
  Handle dataset(H5Dcreate2(group, name.c_str(), file_type, space, H5P_DEFAULT, properties, H5P_DEFAULT));
  if (bytes > 0) checked(H5Dwrite(dataset, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data));
  set(dataset, "crc32", crc32_of(data, bytes));
  return dataset;
}

template <class T>
Handle make(hid_t group, std::string const& name, Extent const& extent, std::span<T const> values) {
  return make(group, name, extent, Types<T>::in_file(), Types<T>::in_memory(), values.data(), values.size_bytes());
}

void fill(hid_t dataset, hid_t memory_type, void* data, std::size_t bytes) {
  if (bytes > 0) checked(H5Dread(dataset, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data));
  if (integer(dataset, "crc32") != crc32_of(data, bytes)) throw Failure("its numbers and their checksum disagree");
}

std::size_t elements(Extent const& extent) {
  std::size_t product = 1;
  for (auto const n : extent) product *= n;
  return product;
}

template <class T>
void read_numbers(hid_t dataset, std::span<T> values) {
  Handle const type(H5Dget_type(dataset));
  if (checked(H5Tequal(type, Types<T>::in_file())) == 0) throw Failure("it holds numbers of an unknown type");
  if (elements(extent(dataset)) != values.size()) throw Failure("its arrays do not fit together");
  fill(dataset, Types<T>::in_memory(), values.data(), values.size_bytes());
}

/// An attribute with exactly one value.
Handle open_scalar(hid_t object, char const* name) {
  Handle attribute(H5Aopen(object, name, H5P_DEFAULT));
  Handle const space(H5Aget_space(attribute));
  if (H5Sget_simple_extent_npoints(space) != 1) throw Failure(std::string("its attribute ") + name + " has no value");
  return attribute;
}

void set_scalar(hid_t object, char const* name, hid_t file_type, hid_t memory_type, void const* value) {
  Handle const space(H5Screate(H5S_SCALAR));
  Handle const attribute(H5Acreate2(object, name, file_type, space, H5P_DEFAULT, H5P_DEFAULT));
  checked(H5Awrite(attribute, memory_type, value));
}

template <class T>
T scalar(hid_t object, char const* name) {
  T value = 0;
  checked(H5Aread(open_scalar(object, name), Types<T>::in_memory(), &value));
  return value;
}

/// Bytes of one text of this type. @throws Failure unless it is of fixed length and fits into the file.
std::size_t text_size(hid_t object, hid_t type) {
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0) throw Failure("a text is of an unknown type");
  std::size_t const size = H5Tget_size(type);
  Handle const file(H5Iget_file_id(object));
  hsize_t bytes = 0;
  checked(H5Fget_filesize(file, &bytes));
  if (size > bytes) throw Failure("it is shorter than it says");
  return size;
}

/// Walks the error stack from the innermost failure outwards and keeps the first description.
herr_t keep_first(unsigned, H5E_error2_t const* error, void* reason) {
  auto& text = *static_cast<std::string*>(reason);
  if (text.empty() && error->desc != nullptr) text = error->desc;
  return 0;
}

}  // namespace

/// A damaged file can leave HDF5 with objects that it cannot close, of which its own routine at the program's exit
/// then complains aloud. Every object here is closed by its Handle, so that this routine has nothing to do.
Session::Session() : lock_(one_user_at_a_time) {
  static bool const closed_by_handles = H5dont_atexit() >= 0;
  static_cast<void>(closed_by_handles);
  H5Eget_auto2(H5E_DEFAULT, &printer_, &printer_data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Session::~Session() { H5Eset_auto2(H5E_DEFAULT, printer_, printer_data_); }

template <class Result>
Result checked(Result result) {
  if (result >= 0) return result;
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &reason);
  throw Failure(reason.empty() ? "HDF5 gives no reason" : reason);
}
template int checked(int);      // herr_t, htri_t
template hid_t checked(hid_t);  // and ssize_t

void set(hid_t object, char const* name, std::string const& text) {
  Handle const type = text_type(text.size());
  set_scalar(object, name, type, type, text.c_str());
}
void set(hid_t object, char const* name, std::int64_t number) {
  set_scalar(object, name, H5T_STD_I64LE, H5T_NATIVE_INT64, &number);
}
void set(hid_t object, char const* name, double number) {
  set_scalar(object, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &number);
}

bool has(hid_t object, char const* name) { return checked(H5Aexists(object, name)) > 0; }

std::string text(hid_t object, char const* name) {
  Handle const attribute = open_scalar(object, name);
  Handle const type(H5Aget_type(attribute));
  std::string value(text_size(attribute, type), '\0');
  checked(H5Aread(attribute, type, value.data()));
  return value.substr(0, value.find('\0'));
}
std::int64_t integer(hid_t object, char const* name) { return scalar<std::int64_t>(object, name); }
double real(hid_t object, char const* name) { return scalar<double>(object, name); }

Handle create(hid_t group, std::string const& name, Extent const& extent, std::span<double const> values) {
  return make(group, name, extent, values);
}
Handle create(hid_t group, std::string const& name, Extent const& extent, std::span<std::int64_t const> values) {
  return make(group, name, extent, values);
}
Handle create(hid_t group, std::string const& name, std::vector<std::string> const& texts) {
  std::size_t longest = 1;
  for (auto const& text : texts) longest = std::max(longest, text.size());
  std::string packed;
  for (auto text : texts) text.resize(longest), packed += text;
  Handle const type = text_type(longest);
  return make(group, name, {texts.size()}, type, type, packed.data(), packed.size());
}

Handle open_to_read(std::filesystem::path const& file) {
  Handle const access(H5Pcreate(H5P_FILE_ACCESS));
  checked(H5Pset_file_locking(access, /*use=*/false, /*ignore_when_disabled=*/true));
  return Handle(H5Fopen(file.c_str(), H5F_ACC_RDONLY, access));
}

Handle open(hid_t group, std::string const& name) { return Handle(H5Dopen2(group, name.c_str(), H5P_DEFAULT)); }

Extent extent(hid_t dataset) {
  Handle const space(H5Dget_space(dataset)), type(H5Dget_type(dataset)), file(H5Iget_file_id(dataset));
  Extent result(static_cast<std::size_t>(checked(H5Sget_simple_extent_ndims(space))));
  checked(H5Sget_simple_extent_dims(space, result.data(), nullptr));
  hsize_t bytes = 0;
  checked(H5Fget_filesize(file, &bytes));
  hsize_t product = std::max<std::size_t>(H5Tget_size(type), 1);
  for (auto const n : result)
    if (__builtin_mul_overflow(product, n, &product) || product > bytes) throw Failure("it is shorter than it says");
  if (product != H5Dget_storage_size(dataset)) throw Failure("its arrays are stored in an unknown way");
  return result;
}

void read(hid_t dataset, std::span<double> values) { read_numbers(dataset, values); }
void read(hid_t dataset, std::span<std::int64_t> values) { read_numbers(dataset, values); }

std::vector<std::string> read_texts(hid_t dataset) {
  std::size_t const count = elements(extent(dataset));
  Handle const type(H5Dget_type(dataset));
  std::size_t const size = text_size(dataset, type);
  std::string packed(count * size, '\0');
  fill(dataset, type, packed.data(), packed.size());
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < count; ++i) {
    auto const padded = packed.substr(i * size, size);
    texts.push_back(padded.substr(0, padded.find('\0')));
  }
  return texts;
}

}  // namespace brouwer::hdf5
