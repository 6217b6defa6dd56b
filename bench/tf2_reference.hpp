#pragma once

#include <array>
#include <memory>
#include <string>

namespace bench {

/// A tf2 buffer behind a plain interface, because tf2's message headers do not compile as C++20.
class Tf2Reference {
 public:
  Tf2Reference();
  Tf2Reference(const Tf2Reference&) = delete;
  Tf2Reference& operator=(const Tf2Reference&) = delete;
  ~Tf2Reference();

  /// The attitude of `child` in `parent` at t, s; quaternions are (w, x, y, z).
  void add(const std::string& parent, const std::string& child, double t, const std::array<double, 4>& q,
           bool fixed);
  std::array<double, 4> look_up(const std::string& target, const std::string& source, double t) const;

 private:
  struct Buffer;
  std::unique_ptr<Buffer> buffer_;
};

}  // namespace bench
