#pragma once

#include <hdf5.h>

#include <string>
#include <vector>

#include "result_file/result_file.hpp"
#include "scenario/replayed.hpp"

namespace vectrix::cli {

/// Without a time: at all samples of the file, which has steps of 20 and 30 s.
inline std::string at_samples(const std::string& text) {
  const std::string gaps = with(text, "gap = \"30 s\"", "gap = \"15 s\"");
  return with(gaps, "start = 2023-04-20T05:20:10Z\nend = 2023-04-20T06:10:00Z\nstep = \"10 s\"", "");
}

/// The bytes of the file that holds a result.
inline std::string stored_bytes(const Result& result) {
  const TemporaryFile file("");
  write_result(result, file.path());
  return content(file.path());
}

/// What the library of HDF5 itself reads in a file.
class PlainHdf5 {
 public:
  explicit PlainHdf5(const std::filesystem::path& file, unsigned mode = H5F_ACC_RDONLY)
      : file_(H5Fopen(file.c_str(), mode, H5P_DEFAULT)) {}
  PlainHdf5(const PlainHdf5&) = delete;
  PlainHdf5& operator=(const PlainHdf5&) = delete;
  ~PlainHdf5() { H5Fclose(file_); }

  [[nodiscard]] hid_t id() const { return file_; }
  [[nodiscard]] std::vector<hsize_t> size(const std::string& path) const {
    const hid_t dataset = H5Dopen2(file_, path.c_str(), H5P_DEFAULT), space = H5Dget_space(dataset);
    std::vector<hsize_t> all(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, all.data(), nullptr);
    H5Sclose(space);
    H5Dclose(dataset);
    return all;
  }
  [[nodiscard]] std::vector<double> numbers(const std::string& path) const {
    hsize_t count = 1;
    for (const hsize_t each : size(path)) count *= each;
    std::vector<double> all(count);
    const hid_t dataset = H5Dopen2(file_, path.c_str(), H5P_DEFAULT);
    EXPECT_GE(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()), 0) << path;
    H5Dclose(dataset);
    return all;
  }
  [[nodiscard]] std::string word(const std::string& path, const char* name) const {
    const hid_t attribute = H5Aopen_by_name(file_, path.c_str(), name, H5P_DEFAULT, H5P_DEFAULT),
                type = H5Aget_type(attribute);
    std::string text(H5Tget_size(type), '\0');
    EXPECT_GE(H5Aread(attribute, type, text.data()), 0) << path;
    H5Tclose(type);
    H5Aclose(attribute);
    return text;
  }
  [[nodiscard]] std::vector<H5Z_filter_t> filters(const std::string& path) const {
    const hid_t dataset = H5Dopen2(file_, path.c_str(), H5P_DEFAULT),
                properties = H5Dget_create_plist(dataset);
    std::vector<H5Z_filter_t> all;
    for (int i = 0; i < H5Pget_nfilters(properties); ++i) {
      unsigned flags = 0;
      std::size_t count = 0;
      all.push_back(
          H5Pget_filter2(properties, static_cast<unsigned>(i), &flags, &count, nullptr, 0, nullptr, nullptr));
    }
    H5Pclose(properties);
    H5Dclose(dataset);
    return all;
  }

  void remove(const std::string& path) const { H5Ldelete(file_, path.c_str(), H5P_DEFAULT); }
  /// The same dataset with other numbers.
  void write(const std::string& path, const std::vector<double>& numbers) const {
    const hid_t dataset = H5Dopen2(file_, path.c_str(), H5P_DEFAULT);
    EXPECT_GE(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()), 0) << path;
    H5Dclose(dataset);
  }
  /// Another dataset instead.
  void replace(const std::string& path, const std::vector<double>& numbers, hsize_t columns) const {
    remove(path);
    const hsize_t size[]{numbers.size() / columns, columns};
    const hid_t space = H5Screate_simple(columns > 1 ? 2 : 1, size, nullptr),
                properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_chunk(properties, columns > 1 ? 2 : 1, size);
    const hid_t dataset =
        H5Dcreate2(file_, path.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
    H5Dclose(dataset);
    H5Pclose(properties);
    H5Sclose(space);
  }
  void set_number(const std::string& path, const char* name, double value) const {
    const hid_t object = H5Oopen(file_, path.c_str(), H5P_DEFAULT),
                attribute = H5Aopen(object, name, H5P_DEFAULT);
    EXPECT_GE(H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value), 0) << path;
    H5Aclose(attribute);
    H5Oclose(object);
  }

 private:
  hid_t file_;
};

}  // namespace vectrix::cli
