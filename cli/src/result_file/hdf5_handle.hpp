#pragma once

#include <hdf5.h>

#include <string>
#include <utility>
#include <vector>

namespace vectrix::cli {

/// Something open in the library of HDF5.
class Hdf5Handle {
 public:
  Hdf5Handle(hid_t id, herr_t (*closing)(hid_t)) : id_(id), close_(closing) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Hdf5Handle& operator=(Hdf5Handle&&) = delete;
  ~Hdf5Handle() { (void)close(); }

  [[nodiscard]] hid_t id() const { return id_; }
  [[nodiscard]] bool is_open() const { return id_ >= 0; }
  [[nodiscard]] herr_t close() { return id_ < 0 ? 0 : close_(std::exchange(id_, -1)); }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// The library must not write to the standard error; what went wrong is asked of it.
inline void silence_hdf5() {
  (void)H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

inline herr_t keep_innermost_error(unsigned place, const H5E_error2_t* error, void* text) {
  if (place == 0 && error->desc) *static_cast<std::string*>(text) = error->desc;
  return 0;
}
inline std::string hdf5_reason() {
  std::string text;
  (void)H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost_error, &text);
  return text.empty() ? "" : " (" + text + ")";
}

/// The path and all above it: "/a", "/a/b".
inline std::vector<std::string> hdf5_steps_of(const std::string& path) {
  std::vector<std::string> steps;
  for (auto at = path.find('/', 1); at != std::string::npos; at = path.find('/', at + 1))
    steps.push_back(path.substr(0, at));
  if (path != "/") steps.push_back(path);
  return steps;
}

}  // namespace vectrix::cli
