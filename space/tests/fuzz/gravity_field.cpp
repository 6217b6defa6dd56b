// Any file is a field, which answers outside the Earth, or is refused. The first byte is the degree.
#include <vectrix/space/fields/gravity_field.hpp>

#include "input_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace vectrix;
  if (size == 0) return 0;
  const fuzz::InputFile file(bytes + 1, size - 1);
  const auto field = fuzz::accepted([&] { return GravityField::read(file.path(), bytes[0] % 8); });
  if (!field) return 0;
  static_cast<void>(field->with_gradient(
      vector<si::length>(in<earth::Itrf>, Eigen::Vector3d(2.0, -1.0, 3.0) * field->radius().value())));
  return 0;
}
