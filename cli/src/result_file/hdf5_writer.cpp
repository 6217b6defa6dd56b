#include <algorithm>
#include <array>

#include <vectrix/frames/errors.hpp>

#include "result_file/hdf5_file.hpp"
#include "result_file/hdf5_handle.hpp"

namespace vectrix::cli {
namespace {

constexpr hsize_t chunk_bytes = 512 * 1024;

Hdf5Handle text_type(std::size_t size) {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  (void)H5Tset_size(type.id(), std::max<std::size_t>(size, 1));
  (void)H5Tset_cset(type.id(), H5T_CSET_UTF8);
  (void)H5Tset_strpad(type.id(), H5T_STR_NULLPAD);
  return type;
}

Hdf5Handle scalar() {
  return {H5Screate(H5S_SCALAR), H5Sclose};
}

template <class Id> Id made(Id id, const std::string& what) {
  if (id < 0) throw BadInput(what + " cannot be written" + hdf5_reason());
  return id;
}

void keep_no_times(hid_t properties) {
  (void)H5Pset_obj_track_times(properties, false);
}

}  // namespace

class Hdf5Writer::Content {
 public:
  explicit Content(const std::filesystem::path& file) : file_(create(file), H5Fclose) {}

  Hdf5Handle opened(const std::string& path) {
    make_groups(hdf5_steps_of(path));
    return {made(H5Oopen(file_.id(), path.c_str(), H5P_DEFAULT), path), H5Oclose};
  }

  void add_attribute(const std::string& path, const std::string& name, hid_t type, const void* value) {
    const Hdf5Handle object = opened(path), space = scalar();
    const Hdf5Handle attribute(
        made(H5Acreate2(object.id(), name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT), name),
        H5Aclose);
    made(H5Awrite(attribute.id(), type, value), name);
  }

  void add_dataset(const std::string& path, hid_t type, hsize_t rows, hsize_t columns, const void* values) {
    auto groups = hdf5_steps_of(path);
    groups.pop_back();
    make_groups(groups);
    const std::array<hsize_t, 2> size{rows, columns};
    const int dimensions = columns > 1 ? 2 : 1;
    const Hdf5Handle space(made(H5Screate_simple(dimensions, size.data(), nullptr), path), H5Sclose);
    const Hdf5Handle properties(made(H5Pcreate(H5P_DATASET_CREATE), path), H5Pclose);
    keep_no_times(properties.id());
    if (rows > 0) {
      const hsize_t fitting = chunk_bytes / (columns * H5Tget_size(type));
      const std::array<hsize_t, 2> chunk{std::clamp<hsize_t>(fitting, 1, rows), columns};
      (void)H5Pset_chunk(properties.id(), dimensions, chunk.data());
      (void)H5Pset_shuffle(properties.id());
      (void)H5Pset_deflate(properties.id(), 4);
      (void)H5Pset_fletcher32(properties.id());
    }
    const Hdf5Handle dataset(made(H5Dcreate2(file_.id(), path.c_str(), type, space.id(), H5P_DEFAULT,
                                             properties.id(), H5P_DEFAULT),
                                  path),
                             H5Dclose);
    if (rows > 0) made(H5Dwrite(dataset.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), path);
  }

  void link(const std::string& path, const std::string& there) {
    auto groups = hdf5_steps_of(path);
    groups.pop_back();
    make_groups(groups);
    made(H5Lcreate_hard(file_.id(), there.c_str(), file_.id(), path.c_str(), H5P_DEFAULT, H5P_DEFAULT), path);
  }

  void close() { made(file_.close(), "the file"); }

 private:
  static hid_t create(const std::filesystem::path& file) {
    silence_hdf5();
    const Hdf5Handle access(made(H5Pcreate(H5P_FILE_ACCESS), "the file"), H5Pclose);
    const Hdf5Handle creation(made(H5Pcreate(H5P_FILE_CREATE), "the file"), H5Pclose);
    made(H5Pset_file_locking(access.id(), false, true), "the file");
    // From this form on the structure of the file has checksums.
    made(H5Pset_libver_bounds(access.id(), H5F_LIBVER_V110, H5F_LIBVER_V110), "the file");
    keep_no_times(creation.id());
    return made(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), "the file");
  }

  void make_groups(const std::vector<std::string>& steps) {
    for (const std::string& path : steps) {
      if (H5Lexists(file_.id(), path.c_str(), H5P_DEFAULT) > 0) continue;
      const Hdf5Handle properties(made(H5Pcreate(H5P_GROUP_CREATE), path), H5Pclose);
      keep_no_times(properties.id());
      const Hdf5Handle group(
          made(H5Gcreate2(file_.id(), path.c_str(), H5P_DEFAULT, properties.id(), H5P_DEFAULT), path),
          H5Gclose);
    }
  }

  Hdf5Handle file_;
};

Hdf5Writer::Hdf5Writer(const std::filesystem::path& file) : content_(std::make_unique<Content>(file)) {}
Hdf5Writer::~Hdf5Writer() = default;

void Hdf5Writer::add_words(const std::string& path, const Hdf5Words& words) {
  for (const auto& [name, text] : words) {
    const Hdf5Handle type = text_type(text.size());
    content_->add_attribute(path, name, type.id(), text.c_str());
  }
}
void Hdf5Writer::add_number(const std::string& path, const std::string& name, double value) {
  content_->add_attribute(path, name, H5T_IEEE_F64LE, &value);
}
void Hdf5Writer::add(const std::string& path, const std::vector<double>& numbers, std::size_t columns) {
  content_->add_dataset(path, H5T_IEEE_F64LE, numbers.size() / columns, columns, numbers.data());
}
void Hdf5Writer::add(const std::string& path, const std::vector<std::int64_t>& numbers) {
  content_->add_dataset(path, H5T_STD_I64LE, numbers.size(), 1, numbers.data());
}
void Hdf5Writer::add(const std::string& path, const std::vector<std::string>& texts, std::size_t columns) {
  std::size_t longest = 1;
  for (const std::string& text : texts) longest = std::max(longest, text.size());
  std::string all;
  for (const std::string& text : texts) all.append(text).append(longest - text.size(), '\0');
  content_->add_dataset(path, text_type(longest).id(), texts.size() / columns, columns, all.data());
}
void Hdf5Writer::link(const std::string& path, const std::string& there) {
  content_->link(path, there);
}
void Hdf5Writer::close() {
  content_->close();
}

}  // namespace vectrix::cli
