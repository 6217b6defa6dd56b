#include <array>
#include <utility>
#include <vectrix/kinematics/attitude/euler_angles.hpp>

#include "subjects.hpp"

namespace vectrix::accuracy {
namespace {

/// One of the 24 sequences, with the library's functions for it.
struct Sequence {
  std::string name;
  std::array<int, 3> axes;
  bool intrinsic, proper;
  Eigen::Matrix3d (*dcm)(const Eigen::Vector3d&);
  Eigen::Vector4d (*quaternion)(const Eigen::Vector3d&);
  Eigen::Vector3d (*from_dcm)(const Eigen::Matrix3d&);
};

template <class S> auto angles_of(S sequence, const Eigen::Vector3d& t) {
  return euler_angles(sequence, of<B>, relative_to<A>, t(0) * si::radian, t(1) * si::radian,
                      t(2) * si::radian);
}
template <class S> Sequence described() {
  return {S::name(),
          {S::first, S::second, S::third},
          S::intrinsic,
          S::proper,
          [](const Eigen::Vector3d& t) { return dcm(angles_of(S{}, t)).matrix(); },
          [](const Eigen::Vector3d& t) -> Eigen::Vector4d {
            return quaternion(angles_of(S{}, t)).eigen().coeffs();
          },
          [](const Eigen::Matrix3d& R) { return euler_angles(S{}, R_of<A, B>(R)).coordinates(); }};
}
template <template <int, int, int> class Kind> void add_twelve(std::vector<Sequence>& list) {
  const Sequence twelve[] = {
      described<Kind<1, 2, 3>>(), described<Kind<1, 3, 2>>(), described<Kind<2, 1, 3>>(),
      described<Kind<2, 3, 1>>(), described<Kind<3, 1, 2>>(), described<Kind<3, 2, 1>>(),
      described<Kind<1, 2, 1>>(), described<Kind<1, 3, 1>>(), described<Kind<2, 1, 2>>(),
      described<Kind<2, 3, 2>>(), described<Kind<3, 1, 3>>(), described<Kind<3, 2, 3>>()};
  list.insert(list.end(), std::begin(twelve), std::end(twelve));
}
const Sequence& sequence_of(const Draw& draw) {
  static const std::vector<Sequence> all = [] {
    std::vector<Sequence> list;
    add_twelve<Intrinsic>(list);
    add_twelve<Extrinsic>(list);
    return list;
  }();
  return all[draw.index % all.size()];
}

std::array<WideSquare, 3> factors(const Sequence& sequence, const Eigen::Vector3d& t) {
  std::array<WideSquare, 3> R;
  for (std::size_t n = 0; n < 3; ++n) {
    const Wide angle = static_cast<Wide>(t(static_cast<Eigen::Index>(n)));
    R[n] = Eigen::AngleAxis<Wide>(angle, WideColumn::Unit(sequence.axes[n])).toRotationMatrix();
  }
  return R;
}
WideSquare product_of(const Sequence& sequence, const Eigen::Vector3d& t) {
  const auto R = factors(sequence, t);
  return sequence.intrinsic ? R[0] * R[1] * R[2] : R[2] * R[1] * R[0];
}
// The axes of the three turns, in b. A small change of the angles turns b by the sum of axis times change.
WideSquare axes_in_turned(const Sequence& sequence, const Eigen::Vector3d& t) {
  auto R = factors(sequence, t);
  auto axes = sequence.axes;
  if (!sequence.intrinsic) {
    std::swap(R[0], R[2]);
    std::swap(axes[0], axes[2]);
  }
  WideSquare u;
  u.col(2) = WideColumn::Unit(axes[2]);
  u.col(1) = R[2].transpose() * WideColumn::Unit(axes[1]);
  u.col(0) = (R[1] * R[2]).transpose() * WideColumn::Unit(axes[0]);
  if (!sequence.intrinsic) u.col(0).swap(u.col(2));
  return u;
}

Eigen::Vector3d any_angles(Draw& draw) {
  return draw.cube(2 * std::numbers::pi);
}
Eigen::Vector3d angles_near_lock(const Sequence& sequence, Draw& draw, double distance) {
  Eigen::Vector3d t = draw.cube(3.0);
  const double side = draw.uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0;
  t(1) = sequence.proper ? (side < 0 ? distance : std::numbers::pi - distance)
                         : side * (std::numbers::pi / 2 - distance);
  return t;
}

Found forward_error(const Sequence& sequence, const Eigen::Matrix3d& R, Wide gain, double place) {
  const Eigen::Vector3d t = sequence.from_dcm(R);
  // The rotation from that of the computed angles to the given one, and the change of the angles that it
  // causes.
  const WideColumn turn = rotation_vector_of(
      nearest_rotation(product_of(sequence, t).transpose() * nearest_rotation(widened(R))));
  const WideColumn change = axes_in_turned(sequence, t).inverse() * turn;
  return {change.norm() / gain * ulps_in_one, sequence.name + ", rad from the lock", place};
}
Found backward_error(const Sequence& sequence, const Eigen::Matrix3d& R, double place) {
  const Eigen::Vector3d t = sequence.from_dcm(R);
  return {turn_between(product_of(sequence, t), nearest_rotation(widened(R))) * ulps_in_one,
          sequence.name + ", rad from the lock", place};
}
double distance_from_lock(const Sequence& sequence, const Eigen::Matrix3d& R) {
  const double second = sequence.from_dcm(R)(1);
  return std::abs(sequence.proper ? std::sin(second) : std::cos(second));
}

void from_angles(Table& table) {
  table.row(
      "dcm(angles)", "any angles, -6.28 to 6.28 rad; 24 sequences in turn", "1",
      roundings(24, "sines and cosines 2 for each of three turns; two products, 3 on each of nine entries"),
      [](Draw& draw) {
        const Sequence& sequence = sequence_of(draw);
        const Eigen::Vector3d t = any_angles(draw);
        return compare(sequence.dcm(t), product_of(sequence, t), 1, sequence.name.c_str(), t(1));
      });
  table.row("quaternion(angles)", "any angles, -6.28 to 6.28 rad; 24 sequences in turn", "1",
            roundings(22, "sines and cosines 2 for each of three turns; two products of 8"), [](Draw& draw) {
              const Sequence& sequence = sequence_of(draw);
              const Eigen::Vector3d t = any_angles(draw);
              return compare_up_to_sign(sequence.quaternion(t), quaternion_of(product_of(sequence, t)),
                                        sequence.name.c_str(), t(1));
            });
}

void to_angles(Table& table) {
  const Bound backward =
      roundings(49,
                "entries of R, each wrong by one rounding, used in several ways, 9; root and division 5, arc "
                "tangents 5 each; the first angle, after the third turn is removed, 8");
  const Bound forward = roundings(
      70, "the backward 49, times the square root of 2, because the axes are not normal to each other");
  table.row("euler_angles(R)", "0.5 rad and more from gimbal lock; 24 sequences in turn",
            "1 / sine of the distance", forward, [](Draw& draw) {
              const Sequence& sequence = sequence_of(draw);
              const double distance = draw.uniform(0.5, std::numbers::pi / 2);
              const Eigen::Matrix3d R =
                  product_of(sequence, angles_near_lock(sequence, draw, distance)).cast<double>();
              return forward_error(sequence, R, 1 / std::sin(static_cast<Wide>(distance)), distance);
            });
  table.row("euler_angles(R)", "1e-12 to 0.5 rad from gimbal lock; 24 sequences in turn",
            "1 / sine of the distance", forward, [](Draw& draw) {
              const Sequence& sequence = sequence_of(draw);
              const double distance = draw.logarithmic(1e-12, 0.5);
              const Eigen::Matrix3d R =
                  product_of(sequence, angles_near_lock(sequence, draw, distance)).cast<double>();
              return forward_error(sequence, R, 1 / std::sin(static_cast<Wide>(distance)), distance);
            });
  table.row("euler_angles(R), backward", "any rotation; 24 sequences in turn", "1", backward, [](Draw& draw) {
    const Sequence& sequence = sequence_of(draw);
    const Eigen::Matrix3d R = any_dcm(draw);
    return backward_error(sequence, R, distance_from_lock(sequence, R));
  });
  const auto near_row = [&](const char* domain, double from, double to, const Bound& bound) {
    table.row("euler_angles(R), backward", domain, "1", bound, [from, to](Draw& draw) {
      const Sequence& sequence = sequence_of(draw);
      const double distance = draw.logarithmic(from, to);
      const Eigen::Matrix3d R =
          product_of(sequence, angles_near_lock(sequence, draw, distance)).cast<double>();
      return backward_error(sequence, R, distance);
    });
  };
  near_row("3e-15 to 1e-3 rad from gimbal lock; 24 sequences in turn", 3e-15, 1e-3, backward);
  near_row("1e-17 to 3e-15 rad from gimbal lock; 24 sequences in turn", 1e-17, 3e-15,
           {backward.ulps + 16,
            "the same, and twice 8 ulp: within 8 ulp of the lock the third angle is set to zero"});
  table.row("euler_angles(R), backward", "at gimbal lock, to rounding; 24 sequences in turn", "1", backward,
            [](Draw& draw) {
              const Sequence& sequence = sequence_of(draw);
              const Eigen::Matrix3d R =
                  product_of(sequence, angles_near_lock(sequence, draw, 0.0)).cast<double>();
              return backward_error(sequence, R, 0.0);
            });
  table.row(
      "euler_angles(R), backward", "special: the 24 rotations of a cube; 24 sequences", "1", backward,
      [](Draw& draw) {
        const Sequence& sequence = sequence_of(draw);
        const auto n = static_cast<int>(draw.index / 24);
        const Eigen::Matrix3d first =
            Eigen::AngleAxisd((n % 4) * std::numbers::pi / 2, Eigen::Vector3d::UnitX()).toRotationMatrix();
        const int face = n / 4;
        const Eigen::Vector3d axis = face < 4 ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
        const double angle = (face < 4 ? face : 2 * face - 9) * std::numbers::pi / 2;
        const Eigen::Matrix3d R = (Eigen::AngleAxisd(angle, axis).toRotationMatrix() * first).array().round();
        return backward_error(sequence, R, distance_from_lock(sequence, R));
      },
      24 * 24);
}

}  // namespace

void euler_rows(Table& table) {
  table.section(
      "Euler angles",
      "References: the product of the three turns. For the angles found: the small turn that is left "
      "between their rotation and the rotation given, converted to angles by the three axes.");
  from_angles(table);
  to_angles(table);
}

}  // namespace vectrix::accuracy
