#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "says.hpp"
#include "stored.hpp"

#ifdef VECTRIX_SANITIZED
// HDF5 1.10.8 loses memory of its own where it finds damage.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libhdf5";
}
#endif

namespace vectrix::cli::damaged_result_test {
namespace {

class DamagedResult : public ::testing::Test {
 protected:
  DamagedResult() : bytes_(stored_bytes(cli::replayed(example("sentinel1.toml")).result())) {}

  [[nodiscard]] std::filesystem::path written(const std::string& bytes) const {
    return folder_.written("r.h5", bytes);
  }
  /// What is said of the file after a change.
  [[nodiscard]] std::string after(const std::function<void(const PlainHdf5&)>& change) const {
    const auto file = written(bytes_);
    change(PlainHdf5(file, H5F_ACC_RDWR));
    return complaint([&] { (void)read_result(file); }, file);
  }
  [[nodiscard]] std::string said_of(const std::string& bytes) const {
    const auto file = written(bytes);
    return complaint([&] { (void)read_result(file); }, file);
  }

  std::string bytes_;  // before the folder: making them uses one of the same name
  TemporaryFolder folder_;
};

TEST_F(DamagedResult, IsHdf5) {
  EXPECT_TRUE(says(said_of("no HDF5"), "FILE: is no file of HDF5, or damaged"));
  EXPECT_TRUE(says(said_of(""), "FILE: is no file of HDF5, or damaged"));
  const auto none = folder_.file("none.h5");
  EXPECT_EQ(complaint([&] { (void)read_result(none); }, none), "FILE: cannot be read");
  EXPECT_EQ(complaint([&] { (void)read_result(folder_.file("")); }, folder_.file("")),
            "FILE: cannot be read");
}

TEST_F(DamagedResult, IsAResultOfThisForm) {
  EXPECT_EQ(after([](const PlainHdf5& file) { file.set_number("/", "form", 2.0); }),
            "FILE: / has the form 2, written by vectrix 0; this program reads the form 1");
  EXPECT_EQ(after([](const PlainHdf5& file) { H5Adelete(file.id(), "format"); }),
            "FILE: / has no attribute 'format'");
  // One that the library writes by default has no checksums.
  const auto file = folder_.file("old.h5");
  H5Fclose(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  EXPECT_EQ(complaint([&] { (void)read_result(file); }, file),
            "FILE: is HDF5 without checksums, not as vectrix replay --hdf5 writes it");
}

TEST_F(DamagedResult, HasItsDatasets) {
  for (const char* path :
       {"/attitude/tai", "/samples/quaternion", "/samples/gaps", "/orbit/velocity", "/measures/2/angle",
        "/verdicts/margin", "/choices", "/scenario/texts", "/page/tables/2/rows", "/measures"})
    EXPECT_TRUE(says(after([&](const PlainHdf5& file) { file.remove(path); }),
                     std::string("FILE: ") + path +
                         (std::string(path) == "/measures" ? "/names is missing" : " is missing")));
  EXPECT_EQ(after([](const PlainHdf5& file) {
              file.remove("/orbit/position");
              H5Lcreate_external("other.h5", "/r", file.id(), "/orbit/position", H5P_DEFAULT, H5P_DEFAULT);
            }),
            "FILE: /orbit/position is missing");
}

TEST_F(DamagedResult, HasAsManyRowsAsThereAreInstants) {
  EXPECT_EQ(after([](const PlainHdf5& file) {
              file.replace("/measures/1/angle", std::vector<double>(25, 1.0), 1);
            }),
            "FILE: /measures/1/angle has 25 rows, not 26");
  EXPECT_EQ(after([](const PlainHdf5& file) {
              file.replace("/attitude/quaternion", std::vector<double>(78, 1.0), 3);
            }),
            "FILE: /attitude/quaternion has 3 columns, not 4");
  EXPECT_EQ(after([](const PlainHdf5& file) {
              file.replace("/choices", {1.0, 2.0}, 1);
            }),
            "FILE: /choices holds values of another kind");
  EXPECT_EQ(after([](const PlainHdf5& file) {
              file.replace("/attitude/tai", {2459683.5, 0.25}, 2);
            }),
            "FILE: /attitude/tai has fewer than two rows");
}

TEST_F(DamagedResult, HasNumbers) {
  const auto with_value = [&](const char* path, std::size_t place, double value) {
    return after([&](const PlainHdf5& file) {
      auto all = file.numbers(path);
      all[place] = value;
      file.write(path, all);
    });
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                   inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(with_value("/measures/2/angle", 3, nan), "FILE: /measures/2/angle holds nan in row 4");
  EXPECT_EQ(with_value("/orbit/position", 4, inf), "FILE: /orbit/position holds inf in row 2");
  EXPECT_TRUE(
      says(with_value("/attitude/quaternion", 8, 2.0), "FILE: /attitude/quaternion has in row 3 the norm "));
  EXPECT_EQ(with_value("/attitude/tai", 6, 2459680.5),
            "FILE: /attitude/tai has in row 4 a time that is not after the row before");
  EXPECT_EQ(with_value("/orbit/geodetic", 0, 91.0),
            "FILE: /orbit/geodetic has in row 1 a place that is not on the Earth");
  for (const double no_date : {1e5, 2436000.5})  // before the year 0; before 1960
    EXPECT_TRUE(
        says(with_value("/attitude/tai", 0, no_date), "FILE: /attitude/tai holds a time that has no date: "));
  EXPECT_TRUE(
      says(after([](const PlainHdf5& file) { file.set_number("/attitude/tai", "tai_minus_utc_last", 38.0); }),
           "FILE: /attitude/tai was written with 38 s from UTC to TAI, where this program has 37 s"));
}

// A size that the bytes of the file cannot have, which must not be made room for.
TEST_F(DamagedResult, HoldsNoMoreThanItsBytesCan) {
  EXPECT_EQ(after([](const PlainHdf5& file) {
              file.remove("/orbit/visible_sun");
              const hsize_t size = hsize_t{1} << 40, chunk = 1024;
              const hid_t space = H5Screate_simple(1, &size, nullptr),
                          properties = H5Pcreate(H5P_DATASET_CREATE);
              H5Pset_chunk(properties, 1, &chunk);
              H5Dclose(H5Dcreate2(file.id(), "/orbit/visible_sun", H5T_IEEE_F64LE, space, H5P_DEFAULT,
                                  properties, H5P_DEFAULT));
              H5Pclose(properties);
              H5Sclose(space);
            }),
            "FILE: /orbit/visible_sun has 1099511627776 rows, more than the file can hold");
}

// Checksums find each damage that changes what is read, and nothing is left open.
TEST_F(DamagedResult, IsRefusedOrUnchanged) {
  std::size_t refused = 0, tried = 0;
  constexpr std::size_t step = 101;
  for (std::size_t at = 0; at < bytes_.size(); at += step) {
    std::string damaged = bytes_;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
    const auto file = written(damaged);
    ++tried;
    try {
      EXPECT_TRUE(stored_bytes(read_result(file)) == bytes_) << "byte " << at;
    } catch (const BadInput& error) {
      ++refused;
      EXPECT_TRUE(says(error.what(), file.string() + ": "));
    }
    EXPECT_EQ(H5Fget_obj_count(H5F_OBJ_ALL, H5F_OBJ_ALL), 0);
  }
  EXPECT_GT(2 * refused, tried);  // else most of the file is not looked at
  for (std::size_t size = bytes_.size() - 1; size > 0; size /= 2)
    EXPECT_TRUE(says(said_of(bytes_.substr(0, size)), "FILE: "));
}

}  // namespace
}  // namespace vectrix::cli::damaged_result_test
