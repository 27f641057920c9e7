#pragma once
// Files such as other programs write, by HDF5's own functions: nothing of the reader is used.
#include <brouwer/store/hdf5.hpp>
#include <filesystem>
#include <hdf5_hl.h>
#include <string>
#include <vector>

namespace brouwer {

/// How a data set is stored.
struct Storage {
  hid_t type = H5T_IEEE_F64LE;
  hdf5::Extent chunk = {};  ///< empty: contiguous
  bool compressed = false;
};

/// A new HDF5 file, closed when it goes.
class Hdf5Writer {
 public:
  explicit Hdf5Writer(std::filesystem::path const& file, hsize_t user_block = 0) : file_(create(file, user_block)) {}

  Hdf5Writer& group(std::string const& name) {
    hdf5::Handle const made(H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    return *this;
  }

  Hdf5Writer& numbers(std::string const& name, hdf5::Extent const& extent, std::vector<double> const& values,
                      Storage const& storage = {}) {
    hdf5::Handle const space(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr)),
        properties(H5Pcreate(H5P_DATASET_CREATE));
    if (!storage.chunk.empty()) H5Pset_chunk(properties, static_cast<int>(extent.size()), storage.chunk.data());
    if (storage.compressed) H5Pset_deflate(properties, 6);
    hdf5::Handle const dataset(
        H5Dcreate2(file_, name.c_str(), storage.type, space, H5P_DEFAULT, properties, H5P_DEFAULT));
    if (!values.empty()) H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    return *this;
  }

  Hdf5Writer& scale(std::string const& dataset, unsigned axis, std::string const& scale) {
    hdf5::Handle const of = hdf5::open(file_, dataset), with = hdf5::open(file_, scale);
    if (H5DSis_scale(with) <= 0) H5DSset_scale(with, scale.c_str());
    H5DSattach_scale(of, with, axis);
    return *this;
  }

  /// Of variable length, as h5py writes them.
  Hdf5Writer& text(std::string const& object, char const* name, char const* value) {
    hdf5::Handle const to(H5Oopen(file_, object.c_str(), H5P_DEFAULT)), type(H5Tcopy(H5T_C_S1)),
        space(H5Screate(H5S_SCALAR));
    H5Tset_size(type, H5T_VARIABLE);
    hdf5::Handle const attribute(H5Acreate2(to, name, type, space, H5P_DEFAULT, H5P_DEFAULT));
    H5Awrite(attribute, type, static_cast<void const*>(&value));
    return *this;
  }

 private:
  static hdf5::Handle create(std::filesystem::path const& file, hsize_t user_block) {
    hdf5::Handle const creation(H5Pcreate(H5P_FILE_CREATE));
    H5Pset_userblock(creation, user_block);
    return hdf5::Handle(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, creation, H5P_DEFAULT));
  }
  hdf5::Handle file_;
};

}  // namespace brouwer
