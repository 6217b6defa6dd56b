#include "testing/attitudes.hpp"

namespace vectrix_test {

rc::Gen<double> coordinate() {
  return rc::gen::map(rc::gen::inRange(-1'000'000, 1'000'001), [](int n) { return n / 1e6; });
}

rc::Gen<Eigen::Vector3d> triple() {
  return rc::gen::map(rc::gen::tuple(coordinate(), coordinate(), coordinate()), [](const auto& t) {
    return Eigen::Vector3d(std::get<0>(t), std::get<1>(t), std::get<2>(t));
  });
}

rc::Gen<Eigen::Quaterniond> attitude() {
  const auto scaled = [](const Eigen::Vector3d& v, double scale) {
    return Eigen::Quaterniond(1.0, scale * v.x(), scale * v.y(), scale * v.z()).normalized();
  };
  return rc::gen::oneOf(rc::gen::elementOf(hard_attitudes()),
                        rc::gen::map(triple(), [=](const auto& v) { return scaled(v, 1e-8); }),
                        rc::gen::map(triple(), [=](const auto& v) { return scaled(v, 1.0); }),
                        rc::gen::map(triple(), [=](const auto& v) { return scaled(v, 30.0); }));
}

rc::Gen<Eigen::Matrix3d> rotation_matrix() {
  return rc::gen::map(attitude(), [](const auto& q) { return q.toRotationMatrix(); });
}

}  // namespace vectrix_test

namespace rc {
template class Gen<Eigen::Vector3d>;
template class Gen<Eigen::Quaterniond>;
template class Gen<Eigen::Matrix3d>;
}  // namespace rc
