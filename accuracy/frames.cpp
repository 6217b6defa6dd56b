#include "subjects.hpp"

namespace vectrix::accuracy {
namespace {

const Bound matrix_vector = roundings(6, "products and sums 3 to a component, |R||r| being up to 2 |r|");

template <int axis> void turned_row(Table& table, const char* name) {
  table.row(name, "any angle, 1e-300 to 1e6 rad", "1", roundings(4, "sine and cosine 2 each, twice in R"),
            [](Draw& draw) {
              const double angle = draw.logarithmic(1e-300, 1e6);
              const auto R = [&] {
                if constexpr (axis == 0) return turned_x(to<B>, from<A>, angle * si::radian).matrix();
                if constexpr (axis == 1) return turned_y(to<B>, from<A>, angle * si::radian).matrix();
                if constexpr (axis == 2) return turned_z(to<B>, from<A>, angle * si::radian).matrix();
              }();
              const Wide c = std::cos(static_cast<Wide>(angle)), s = std::sin(static_cast<Wide>(angle));
              WideSquare exact = WideSquare::Identity();
              constexpr int next = (axis + 1) % 3, last = (axis + 2) % 3;
              exact(next, next) = exact(last, last) = c;
              exact(next, last) = s;
              exact(last, next) = -s;
              return compare(R, exact, 1, "angle", angle);
            });
}

void vector_rows(Table& table) {
  table.row(
      "norm(r)", "|r| from 1e-300 to 1e300", "|r|",
      roundings(8, "squares and sums 3, halved by the root 1; scaling 2, where squares under- or overflow"),
      [](Draw& draw) {
        const Eigen::Vector3d r = draw.vector(1e-300, 1e300);
        const Eigen::Matrix<double, 1, 1> found(norm(vector<si::length>(in<A>, r)).value());
        const Eigen::Matrix<Wide, 1, 1> exact(widened(r).norm());
        return compare(found, exact, exact(0), "|r|", r.stableNorm());
      });
  table.row("direction(r)", "|r| from 1e-300 to 1e300", "1",
            roundings(10, "scaling 1, norm 4, division 1, of three components"), [](Draw& draw) {
              const Eigen::Vector3d r = draw.vector(1e-300, 1e300);
              const WideColumn exact = widened(r).normalized();
              return compare(direction(vector<si::length>(in<A>, r)).coordinates(), exact, 1, "|r|",
                             r.stableNorm());
            });
  table.row("cross(r, s)", "any", "|r| |s|", roundings(4, "two products and their difference, on |r_i s_j|"),
            [](Draw& draw) {
              const Eigen::Vector3d r = draw.vector(1e-9, 1e9), s = draw.vector(1e-9, 1e9);
              const auto f = []<class S>(const ColumnOf<S>& r_, const ColumnOf<S>& s_) -> ColumnOf<S> {
                return cross(vector<si::length>(in<A>, r_), vector<si::force>(in<A>, s_)).coordinates();
              };
              return compare(f(r, s), f(widened(r), widened(s)), widened(r).norm() * widened(s).norm(), "|r|",
                             r.norm());
            });
}

void product_rows(Table& table) {
  table.row("R_b_from_a * r_a", "any", "|r|", matrix_vector, [](Draw& draw) {
    const Eigen::Matrix3d R = any_dcm(draw);
    const Eigen::Vector3d r = draw.vector(1e-9, 1e9);
    const auto f = []<class S>(const SquareOf<S>& R_, const ColumnOf<S>& r_) -> ColumnOf<S> {
      return (R_of<B, A>(R_) * vector<si::length>(in<A>, r_)).coordinates();
    };
    return compare(f(R, r), f(widened(R), widened(r)), widened(r).norm(), "|r|", r.norm());
  });
  table.row("rotate(R_a_from_b, r_a)", "any", "|r|", matrix_vector, [](Draw& draw) {
    const Eigen::Matrix3d R = any_dcm(draw);
    const Eigen::Vector3d r = draw.vector(1e-9, 1e9);
    const Eigen::Vector3d found = rotate(R_of<A, B>(R), vector<si::length>(in<A>, r)).coordinates();
    const WideColumn exact = widened(R) * widened(r);
    return compare(found, exact, exact.norm(), "|r|", r.norm());
  });
  table.row("R_c_from_b * R_b_from_a", "any", "1",
            roundings(11, "a product with a vector 6, of three columns"), [](Draw& draw) {
              const Eigen::Matrix3d R = any_dcm(draw), Q = any_dcm(draw);
              const Dcm<C, A> found = R_of<C, B>(R) * R_of<B, A>(Q);
              return compare(found.matrix(), WideSquare(widened(R) * widened(Q)), 1, "", 0);
            });
  table.row("R_b_from_a * R_a_from_b * R_b_from_a * ... * r_a, a chain of 8", "any", "|r|",
            roundings(48, "8 products with a vector, 6 each"), [](Draw& draw) {
              std::array<Eigen::Matrix3d, 8> m;
              for (auto& one : m) one = any_dcm(draw);
              const Eigen::Vector3d r = draw.vector(1e-9, 1e9);
              const auto ba = [&](std::size_t i) { return R_of<B, A>(m[i]); };
              const auto ab = [&](std::size_t i) { return R_of<A, B>(m[i]); };
              const Eigen::Vector3d found = (ab(0) * ba(1) * ab(2) * ba(3) * ab(4) * ba(5) * ab(6) * ba(7) *
                                             vector<si::length>(in<A>, r))
                                                .coordinates();
              WideColumn exact = widened(r);
              for (std::size_t i = 8; i-- > 0;) exact = widened(m[i]) * exact;
              return compare(found, exact, exact.norm(), "|r|", r.norm());
            });
}

template <class S> auto X_of(const SquareOf<S>& R, const ColumnOf<S>& r) {
  return Transform{R_of<B, A>(R), displacement(of<A>, relative_to<B>, vector<si::length>(in<B>, r))};
}

void transform_rows(Table& table) {
  table.row("X_b_from_a * r_aq_a", "any", "|r_aq| + |r_ba|", roundings(8, "product 6, sum 1, twice"),
            [](Draw& draw) {
              const Eigen::Matrix3d R = any_dcm(draw);
              const Eigen::Vector3d r = draw.vector(1e-3, 1e3), s = draw.vector(1e-3, 1e3);
              const auto f = []<class S>(const SquareOf<S>& R_, const ColumnOf<S>& r_,
                                         const ColumnOf<S>& s_) -> ColumnOf<S> {
                const auto r_ac_a = displacement(of<C>, relative_to<A>, vector<si::length>(in<A>, s_));
                return (X_of<S>(R_, r_) * r_ac_a).coordinates();
              };
              return compare(f(R, r, s), f(widened(R), widened(r), widened(s)),
                             widened(r).norm() + widened(s).norm(), "|r_ba|", r.norm());
            });
  table.row("inverse(X_b_from_a), translation", "any", "|r_ba|", matrix_vector, [](Draw& draw) {
    const Eigen::Matrix3d R = any_dcm(draw);
    const Eigen::Vector3d r = draw.vector(1e-3, 1e3);
    const auto f = []<class S>(const SquareOf<S>& R_, const ColumnOf<S>& r_) -> ColumnOf<S> {
      return inverse(X_of<S>(R_, r_)).translation.coordinates();
    };
    return compare(f(R, r), f(widened(R), widened(r)), widened(r).norm(), "|r_ba|", r.norm());
  });
}

void nearest_rows(Table& table) {
  const auto row = [&](const char* domain, double departure, const Bound& bound) {
    table.row("nearest_dcm", domain, "1", bound, [departure](Draw& draw) {
      const Eigen::Matrix3d R = any_dcm(draw);
      Eigen::Matrix3d E;
      E << draw.cube(departure), draw.cube(departure), draw.cube(departure);
      const Eigen::Matrix3d M = R + R * E;
      const Eigen::Matrix3d found = nearest_dcm(to<B>, from<A>, M).dcm.matrix();
      return compare(found, nearest_rotation(widened(M)), 1, "", 0);
    });
  };
  const Bound bound = roundings(
      60, "about 9 plane rotations of rows and columns by Jacobi's method, of 3 each on U and V; U V^T 11");
  row("within 1e-9 of a rotation", 1e-9, bound);
  row("within 0.1 of a rotation", 0.1, bound);
}

}  // namespace

void frame_rows(Table& table) {
  table.section(
      "Frames",
      "Rounding alone, except for `nearest_dcm`: the polar factor by Newton's iteration (the library uses "
      "singular values).");
  turned_row<0>(table, "turned_x");
  turned_row<1>(table, "turned_y");
  turned_row<2>(table, "turned_z");
  vector_rows(table);
  product_rows(table);
  transform_rows(table);
  nearest_rows(table);
}

}  // namespace vectrix::accuracy
