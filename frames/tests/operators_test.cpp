#include <gtest/gtest.h>

#include <iomanip>
#include <sstream>
#include <vectrix/frames.hpp>

#include "testing/attitudes.hpp"

// Operators that assign, and printing.
using namespace vectrix;
using namespace vectrix_test;

namespace operators_test {
namespace {

const auto r = vector(in<Body>, 1.0 * si::metre, -2.0 * si::metre, 0.5 * si::metre);
const auto s = vector(in<Body>, 8.0 * si::metre, 4.0 * si::metre, 2.0 * si::metre);

TEST(Operators, in_place_is_the_same_as_by_value) {
  auto sum = r;
  EXPECT_EQ(&(sum += s), &sum);
  EXPECT_EQ(sum.coordinates(), (r + s).coordinates());
  auto difference = r;
  difference -= s;
  EXPECT_EQ(difference.coordinates(), (r - s).coordinates());
  auto scaled = r;
  scaled *= 3.0;
  EXPECT_EQ(scaled.coordinates(), (3.0 * r).coordinates());
  scaled *= 2.0 * si::metre / si::metre;
  EXPECT_EQ(scaled.coordinates(), (6.0 * r).coordinates());
  auto divided = r;
  divided /= 4.0;
  EXPECT_EQ(divided.coordinates(), (r / 4.0).coordinates());
}

TEST(Operators, a_vector_is_its_own_operand) {
  auto twice = r;
  twice += twice;
  EXPECT_EQ(twice.coordinates(), (2.0 * r).coordinates());
}

template <class Left, class Right>
concept AddsInPlace = requires(Left left, Right right) {
  left += right;
};
template <class Left, class Right>
concept ScalesInPlace = requires(Left left, Right right) {
  left *= right;
};
template <class Left, class Right>
concept Divides = requires(Left left, Right right) {
  left / right;
};
template <class Operand>
concept Negates = requires(Operand operand) {
  -operand;
};
template <class ToFrame, class FromFrame>
concept Aligns = requires(ToFrame b, FromFrame a) {
  aligned(b, a);
};
using Position = Vector<Body, si::length>;
using Velocity = Vector<Body, si::velocity>;

// What is refused also does not satisfy a concept.
static_assert(AddsInPlace<Position, Position> && !AddsInPlace<Position, Velocity>);
static_assert(!AddsInPlace<Position, Vector<Gcrf, si::length>> &&
              !AddsInPlace<Dcm<Body, Gcrf>, Dcm<Body, Gcrf>>);
static_assert(ScalesInPlace<Position, double> && !ScalesInPlace<Position, Quantity<si::time>>);
static_assert(!ScalesInPlace<Dcm<Body, Gcrf>, double>);
static_assert(Divides<Position, Quantity<si::time>> && !Divides<Position, Position>);
static_assert(Negates<Position> && !Negates<Dcm<Body, Gcrf>>);
static_assert(Aligns<To<Body>, From<Gcrf>> && !Aligns<To<Body>, From<Body>> && !Aligns<From<Body>, To<Gcrf>>);

template <class T> std::string printed(const T& value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

// The frames of the tests are in a namespace.
const std::string body = frame_name<Body>();
const std::string gcrf = frame_name<Gcrf>();

TEST(Print, a_vector_says_its_unit_and_frame) {
  EXPECT_EQ(printed(r), "(1, -2, 0.5) m in " + body);
  EXPECT_EQ(printed(unit_x(in<Body>)), "(1, 0, 0) in " + body);
  EXPECT_EQ(printed(r * (1.0 * si::kilogram)), "(1, -2, 0.5) SI units in " + body);
}

TEST(Print, a_rotation_says_its_rows_and_frames) {
  const auto R = turned_z(to<Body>, from<Gcrf>, 0.0 * si::radian);
  EXPECT_EQ(printed(R), "[1 0 0; -0 1 0; 0 0 1] to " + body + " from " + gcrf);
}

TEST(Print, the_stream_says_how_many_digits) {
  std::ostringstream out;
  out << std::setprecision(3) << vector(in<Body>, 3.14159 * si::metre, 0.0 * si::metre, 0.0 * si::metre);
  EXPECT_EQ(out.str(), "(3.14, 0, 0) m in " + body);
}

TEST(Graph, of_float_answers_in_float) {
  const auto graph = frame_graph(static_edge(aligned<float>(to<Body>, from<Gcrf>)));
  const Dcm<Body, Body, float> same = graph.at(0).rotation(to<Body>, from<Body>);
  EXPECT_EQ(same.matrix(), Eigen::Matrix3f::Identity());
}

}  // namespace

// Algebra defined by a user, found by argument-dependent lookup like that of the library.
namespace users {

struct Matrix {};
Matrix product(const Matrix&, const Matrix&);
Matrix quotient(const Matrix&, const Matrix&);
Matrix sum(const Matrix&, const Matrix&);
Matrix difference(const Matrix&, const Matrix&);
Matrix dot_product(const Matrix&, const Matrix&);
Matrix cross_product(const Matrix&, const Matrix&);

}  // namespace users

namespace {

template <class Operand>
concept HasAnyOperator = requires(Operand a, const Operand b) {
  a* b;
}
|| requires(Operand a) {
  a / a;
}
|| requires(Operand a) {
  a + a;
}
|| requires(Operand a) {
  a - a;
}
|| requires(Operand a) {
  a *= a;
}
|| requires(Operand a) {
  a /= a;
}
|| requires(Operand a) {
  a += a;
}
|| requires(Operand a) {
  a -= a;
}
|| requires(Operand a) {
  dot(a, a);
}
|| requires(Operand a) {
  cross(a, a);
};
static_assert(!HasAnyOperator<users::Matrix>);
static_assert(HasAnyOperator<Vector<Body, si::length>> && HasAnyOperator<Dcm<Body, Body>>);

}  // namespace
}  // namespace operators_test
