#include <algorithm>
#include <array>
#include <cmath>
#include <system_error>

#include <vectrix/frames/errors.hpp>

#include "result_file/hdf5_file.hpp"
#include "result_file/hdf5_handle.hpp"

namespace vectrix::cli {
namespace {

constexpr hsize_t most_of_a_byte = 1040;       // deflate makes 1032 bytes of one at most
constexpr std::size_t largest_word = 1 << 16;  // what the head of an object can hold

// Numbers of 8 bytes in the order of this machine, or texts of a fixed size.
bool is_of(hid_t type, H5T_class_t kind) {
  if (kind == H5T_FLOAT) return H5Tequal(type, H5T_IEEE_F64LE) > 0;
  if (kind == H5T_INTEGER) return H5Tequal(type, H5T_STD_I64LE) > 0;
  return H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0;
}

// Without the zeros that fill it.
std::string text_in(const char* bytes, std::size_t size) {
  std::string text(bytes, size);
  text.resize(text.find_last_not_of('\0') + 1);
  return text;
}

}  // namespace

class Hdf5Reader::Content {
 public:
  struct Dataset {
    std::string path;
    Hdf5Handle dataset, type;
    std::size_t rows, columns, size;  // bytes of a value
  };

  explicit Content(const std::filesystem::path& file) : name_(file.string()), file_(open(file), H5Fclose) {
    H5F_info2_t info{};
    if (H5Fget_info2(file_.id(), &info) < 0 || info.super.version < 2)
      throw BadInput(name_ + ": is HDF5 without checksums, not as vectrix replay --hdf5 writes it");
  }

  [[noreturn]] void refuse(const std::string& path, const std::string& why) const {
    throw BadInput(name_ + ": " + path + ' ' + why);
  }

  // Links to other files are not followed.
  [[nodiscard]] bool has(const std::string& path) const {
    for (const std::string& step : hdf5_steps_of(path)) {
      H5L_info_t info{};
      if (H5Lexists(file_.id(), step.c_str(), H5P_DEFAULT) <= 0 ||
          H5Lget_info(file_.id(), step.c_str(), &info, H5P_DEFAULT) < 0 || info.type != H5L_TYPE_HARD)
        return false;
    }
    return true;
  }

  [[nodiscard]] std::string attribute(const std::string& path, const std::string& name,
                                      H5T_class_t kind) const {
    require(path);
    const std::string what = "attribute '" + name + "'";
    const Hdf5Handle object(H5Oopen(file_.id(), path.c_str(), H5P_DEFAULT), H5Oclose);
    if (!object.is_open()) refuse(path, "cannot be read" + hdf5_reason());
    if (H5Aexists(object.id(), name.c_str()) <= 0) refuse(path, "has no " + what + hdf5_reason());
    const Hdf5Handle attribute(H5Aopen(object.id(), name.c_str(), H5P_DEFAULT), H5Aclose);
    const Hdf5Handle type(H5Aget_type(attribute.id()), H5Tclose);
    const Hdf5Handle space(H5Aget_space(attribute.id()), H5Sclose);
    const std::size_t size = H5Tget_size(type.id());
    if (!is_of(type.id(), kind) || H5Sget_simple_extent_npoints(space.id()) != 1 || size > largest_word)
      refuse(path, "has an " + what + " of another kind");
    std::string bytes(size, '\0');
    if (H5Aread(attribute.id(), type.id(), bytes.data()) < 0)
      refuse(path, "has an " + what + " that cannot be read" + hdf5_reason());
    return bytes;
  }

  [[nodiscard]] Dataset dataset(const std::string& path, H5T_class_t kind, std::size_t columns) const {
    require(path);
    Hdf5Handle found(H5Dopen2(file_.id(), path.c_str(), H5P_DEFAULT), H5Dclose);
    if (!found.is_open()) refuse(path, "is no dataset that can be read" + hdf5_reason());
    Hdf5Handle type(H5Dget_type(found.id()), H5Tclose);
    if (!is_of(type.id(), kind)) refuse(path, "holds values of another kind");
    const Hdf5Handle space(H5Dget_space(found.id()), H5Sclose);
    const int dimensions = H5Sget_simple_extent_ndims(space.id());
    std::array<hsize_t, 2> size{0, 1};
    if (dimensions < 1 || dimensions > 2 ||
        H5Sget_simple_extent_dims(space.id(), size.data(), nullptr) != dimensions || size[1] == 0)
      refuse(path, "has " + std::to_string(dimensions) + " dimensions");
    if (size[1] != columns)
      refuse(path, "has " + std::to_string(size[1]) + " columns, not " + std::to_string(columns));
    const std::size_t bytes = H5Tget_size(type.id());
    if (size[0] > 0) require_bounded(path, found, dimensions, size, bytes);
    return {path, std::move(found), std::move(type), size[0], size[1], bytes};
  }

  void read(const Dataset& from, void* to) const {
    if (from.rows > 0 && H5Dread(from.dataset.id(), from.type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, to) < 0)
      refuse(from.path, "cannot be read" + hdf5_reason());
  }

 private:
  [[nodiscard]] hid_t open(const std::filesystem::path& file) const {
    silence_hdf5();
    std::error_code none;  // of what does not exist
    if (!std::filesystem::is_regular_file(file, none)) throw BadInput(name_ + ": cannot be read");
    const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    (void)H5Pset_file_locking(access.id(), false, true);
    const hid_t id = H5Fopen(name_.c_str(), H5F_ACC_RDONLY, access.id());
    if (id < 0) throw BadInput(name_ + ": is no file of HDF5, or damaged" + hdf5_reason());
    return id;
  }

  void require(const std::string& path) const {
    if (!has(path)) refuse(path, "is missing" + hdf5_reason());
  }

  // Before anything of its size is made.
  void require_bounded(const std::string& path, const Hdf5Handle& dataset, int dimensions,
                       const std::array<hsize_t, 2>& rows_and_columns, std::size_t bytes) const {
    const Hdf5Handle properties(H5Dget_create_plist(dataset.id()), H5Pclose);
    std::array<hsize_t, 2> chunk{1, 1};
    if (H5Pget_layout(properties.id()) != H5D_CHUNKED ||
        H5Pget_chunk(properties.id(), dimensions, chunk.data()) != dimensions)
      refuse(path, "is not stored as vectrix stores it, in chunks");
    const int filters = H5Pget_nfilters(properties.id());
    for (unsigned i = 0; std::cmp_less(i, filters); ++i) {
      unsigned flags = 0;
      std::size_t count = 0;
      const auto filter = H5Pget_filter2(properties.id(), i, &flags, &count, nullptr, 0, nullptr, nullptr);
      if (filter != H5Z_FILTER_DEFLATE && filter != H5Z_FILTER_SHUFFLE && filter != H5Z_FILTER_FLETCHER32)
        refuse(path, "has a filter that vectrix does not use");
    }
    const auto& [rows, columns] = rows_and_columns;
    const hsize_t stored =
        std::min<hsize_t>(H5Dget_storage_size(dataset.id()), std::filesystem::file_size(name_));
    if (chunk[0] > rows || chunk[1] > columns || rows > most_of_a_byte * stored / bytes / columns)
      refuse(path, "has " + std::to_string(rows) + " rows, more than the file can hold");
  }

  std::string name_;
  Hdf5Handle file_;
};

Hdf5Reader::Hdf5Reader(const std::filesystem::path& file) : content_(std::make_unique<Content>(file)) {}
Hdf5Reader::~Hdf5Reader() = default;

void Hdf5Reader::refuse(const std::string& path, const std::string& why) const {
  content_->refuse(path, why);
}

bool Hdf5Reader::has(const std::string& path) const {
  return content_->has(path);
}

std::string Hdf5Reader::word(const std::string& path, const std::string& name) const {
  const std::string bytes = content_->attribute(path, name, H5T_STRING);
  return text_in(bytes.data(), bytes.size());
}

double Hdf5Reader::number(const std::string& path, const std::string& name) const {
  const std::string bytes = content_->attribute(path, name, H5T_FLOAT);
  double value = 0.0;
  std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(&value));
  if (!std::isfinite(value)) refuse(path, "has an attribute '" + name + "' that is " + detail::text(value));
  return value;
}

std::vector<double> Hdf5Reader::numbers(const std::string& path, std::size_t columns) const {
  const auto found = content_->dataset(path, H5T_FLOAT, columns);
  std::vector<double> all(found.rows * found.columns);
  content_->read(found, all.data());
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!std::isfinite(all[i]))
      refuse(path, "holds " + detail::text(all[i]) + " in row " + std::to_string(i / columns + 1));
  return all;
}

std::vector<std::int64_t> Hdf5Reader::whole_numbers(const std::string& path) const {
  const auto found = content_->dataset(path, H5T_INTEGER, 1);
  std::vector<std::int64_t> all(found.rows);
  content_->read(found, all.data());
  return all;
}

std::vector<std::string> Hdf5Reader::texts(const std::string& path, std::size_t columns) const {
  const auto found = content_->dataset(path, H5T_STRING, columns);
  std::vector<char> bytes(found.rows * found.columns * found.size);
  content_->read(found, bytes.data());
  std::vector<std::string> all;
  for (std::size_t at = 0; at < bytes.size(); at += found.size)
    all.push_back(text_in(bytes.data() + at, found.size));
  return all;
}

}  // namespace vectrix::cli
