/// Times laws on doubles, in raw Eigen and in the library's types, and on as many doubles at once as the
/// machine's registers hold, on the same numbers. Prints one line per law: the lanes, the law, ns per item in
/// Eigen, with doubles and with lanes, and how many times faster than Eigen the lanes are (the median of all
/// rounds).
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <limits>
#include <random>
#include <tuple>
#include <vectrix/dynamics/rigid/euler.hpp>
#include <vectrix/frames/scalar/lanes.hpp>
#include <vectrix/frames/scalar/larger.hpp>
#include <vectrix/kinematics.hpp>

#include "kernel.hpp"

namespace bench {
namespace {

using namespace vectrix;

struct A : inertial_frame {};
struct B : moving_frame {};
struct C : moving_frame {};
struct D : moving_frame {};

using Clock = std::chrono::steady_clock;
using Lanes = std::experimental::native_simd<double>;

constexpr std::size_t items = 64;  // attitudes with all their operands stay in the first cache
constexpr std::size_t rounds = 2001;
constexpr double round_ns = 20'000.0;
constexpr double same = 1e-13;  // rounding of some tens of operations on numbers of order 1

/// The numbers of one item, or of several items, one per lane.
template <class S> class Numbers {
 public:
  explicit Numbers(std::size_t item) : item_(item) {}

  S operator()() {
    const std::size_t place = place_++;
    const auto number = [&](std::size_t lane) {
      std::mt19937_64 random(100 * (item_ + lane) + place);
      return std::uniform_real_distribution<double>(-1.0, 1.0)(random);
    };
    if constexpr (detail::Batch<S>) {
      return S([&](auto lane) { return number(lane); });
    } else {
      return number(0);
    }
  }
  detail::Column<S> column() {
    const S x = (*this)(), y = (*this)(), z = (*this)();
    return {x, y, z};
  }
  template <class To, class From> Quaternion<To, From, S> quaternion(To, From) {
    const S w = (*this)(), x = (*this)(), y = (*this)(), z = (*this)();
    return nearest_quaternion_scalar_first(to<To>, from<From>, w, x, y, z).quaternion;
  }
  template <class To, class From> Dcm<To, From, S> rotation(To b, From a) { return dcm(quaternion(b, a)); }
  template <class Of, class RelativeTo> AngularVelocity<RelativeTo, Of, In<Of>, S> rate(Of, RelativeTo) {
    return angular_velocity(of<Of>, relative_to<RelativeTo>, vector<si::angular_velocity>(in<Of>, column()));
  }

 private:
  std::size_t item_;
  std::size_t place_ = 0;
};

/// A law on all items, in the scalar S.
template <class S, class Make, class Law> class Sweep {
 public:
  Sweep(const Make& make, const Law& law) : law_(law) {
    const std::size_t step = items / count();
    for (std::size_t i = 0; i < count(); ++i) {
      Numbers<S> numbers(i * step);
      operands_.push_back(make(numbers));
      results_.push_back(std::apply(law_, operands_.back()));
    }
  }

  [[gnu::noinline]] void run() {
    for (std::size_t i = 0; i < results_.size(); ++i)
      new (&results_[i]) Result(std::apply(law_, operands_[i]));
    keep(results_.front());
  }
  bench::Numbers numbers() const {
    bench::Numbers list;
    for (const auto& result : results_) {
      const auto values = entries(result);
      for (std::size_t lane = 0; lane < items / count(); ++lane) {
        for (Eigen::Index k = 0; k < values.size(); ++k) {
          if constexpr (detail::Batch<S>) {
            list.push_back(values.data()[k][lane]);
          } else {
            list.push_back(values.data()[k]);
          }
        }
      }
    }
    return list;
  }

 private:
  static std::size_t count() {
    if constexpr (detail::Batch<S>) {
      return items / S::size();
    } else {
      return items;
    }
  }
  template <class Result> static auto entries(const Result& result) {
    if constexpr (requires { result.eigen(); }) {
      return result.eigen().coeffs();
    } else if constexpr (requires { result.coeffs(); }) {
      return result.coeffs();
    } else if constexpr (requires { result.matrix().data(); }) {
      return result.matrix();
    } else if constexpr (requires { result.coordinates(); }) {
      return result.coordinates();
    } else {
      return result;
    }
  }

  using Operands = std::invoke_result_t<Make, Numbers<S>&>;
  Law law_;
  std::vector<Operands> operands_;
  using Result = detail::Evaluated<decltype(std::apply(std::declval<Law>(), std::declval<Operands>()))>;
  std::vector<Result> results_;
};

/// The largest difference between the numbers of two results, which are stored item after item, `entries`
/// each; q and -q are the same rotation.
double off(const bench::Numbers& found, const bench::Numbers& expected) {
  const std::size_t entries = expected.size() / items;
  double largest = 0.0;
  for (std::size_t item = 0; item < items; ++item) {
    double same_sign = 0.0, other_sign = entries == 4 ? 0.0 : std::numeric_limits<double>::infinity();
    for (std::size_t k = item * entries; k < (item + 1) * entries; ++k) {
      same_sign = vectrix::detail::larger(same_sign, std::abs(found.at(k) - expected[k]));
      other_sign = vectrix::detail::larger(other_sign, std::abs(found.at(k) + expected[k]));
    }
    largest = vectrix::detail::larger(largest, std::min(same_sign, other_sign));
  }
  return largest;
}

double seconds(auto& sweep, long calls) {
  const auto start = Clock::now();
  for (long i = 0; i < calls; ++i) sweep.run();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The law on the same items in Eigen, in doubles and in lanes. Rounds of one batch of each, in random order,
/// so that a slow machine slows all.
template <class Make, class Law, class EigenLaw>
bool time(const char* name, const Make& make, const Law& law, const EigenLaw& eigen_law) {
  Sweep<double, Make, EigenLaw> raw(make, eigen_law);
  Sweep<double, Make, Law> one(make, law);
  Sweep<Lanes, Make, Law> many(make, law);

  constexpr long probe = 100;
  seconds(one, probe);
  const long calls = 1 + static_cast<long>(round_ns / (1e9 * seconds(one, probe) / probe));
  const double per_item = 1e9 / static_cast<double>(calls) / static_cast<double>(items);
  std::mt19937 generator(20240229);
  std::array<int, 3> order{0, 1, 2};
  std::array<std::vector<double>, 3> ns;
  std::vector<double> ratios;
  for (std::size_t round = 0; round < rounds; ++round) {
    std::shuffle(order.begin(), order.end(), generator);
    for (const int way : order) {
      const double time = way == 0   ? seconds(raw, calls)
                          : way == 1 ? seconds(one, calls)
                                     : seconds(many, calls);
      ns.at(static_cast<std::size_t>(way)).push_back(per_item * time);
    }
    ratios.push_back(ns[0].back() / ns[2].back());
  }
  std::printf("%zu\t%s\t%.2f\t%.2f\t%.2f\t%.2f\n", Lanes::size(), name, median(ns[0]), median(ns[1]),
              median(ns[2]), median(ratios));

  const auto expected = raw.numbers();
  const double difference =
      vectrix::detail::larger(off(one.numbers(), expected), off(many.numbers(), expected));
  if (difference <= same) return true;
  std::fprintf(stderr, "lanes: %s: off by %g\n", name, difference);
  return false;
}

}  // namespace
}  // namespace bench

int main() {
  using namespace bench;
  const auto multiply = []<class Left, class Right>(const Left& left, const Right& right)
      -> detail::Evaluated<detail::ProductOf<const Left&, const Right&>> { return left * right; };
  const auto two_rotations = [](auto& n) { return std::tuple{n.rotation(C{}, B{}), n.rotation(B{}, A{})}; };
  const auto rotation_and_vector = [](auto& n) {
    return std::tuple{n.rotation(B{}, A{}), vector<si::length>(in<A>, n.column())};
  };
  const auto two_quaternions = [](auto& n) {
    return std::tuple{n.quaternion(C{}, B{}), n.quaternion(B{}, A{})};
  };
  const auto three_rates = [](auto& n) {
    return std::tuple{n.rate(B{}, A{}), n.rate(C{}, B{}), n.rate(D{}, C{}), n.rotation(C{}, B{}),
                      n.rotation(D{}, C{})};
  };
  const auto rotation_and_rate = [](auto& n) { return std::tuple{n.rotation(A{}, B{}), n.rate(B{}, A{})}; };
  const auto body = [](auto& n) {
    const auto v = n.column();
    using S = typename decltype(n.column())::Scalar;
    const detail::Square<S> J = (S(1) + v.squaredNorm()) * detail::Square<S>::Identity() - v * v.transpose();
    return std::tuple{trust_inertia(in<B>, J), n.rate(B{}, A{}), vector<si::torque>(in<B>, n.column())};
  };
  const auto rotation_vector_of = [](auto& n) {
    return std::tuple{rotation_vector(of<B>, relative_to<A>, vector<si::angle>(in<B>, n.column()))};
  };
  const auto quaternion_of = [](auto& n) { return std::tuple{n.quaternion(A{}, B{})}; };
  const auto rotation_of = [](auto& n) { return std::tuple{n.rotation(A{}, B{})}; };
  const auto eigen_turn = [](const auto& theta_ab) {
    const Eigen::Vector3d& theta = theta_ab.coordinates();
    const double angle = theta.norm();
    return Eigen::AngleAxisd(angle, theta / angle);
  };

  bool agree = time("DCM product", two_rotations, multiply,
                    [](const auto& R_c_from_b, const auto& R_b_from_a) -> Eigen::Matrix3d {
                      return R_c_from_b.matrix() * R_b_from_a.matrix();
                    });
  agree &= time("DCM on a vector", rotation_and_vector, multiply,
                [](const auto& R_b_from_a, const auto& r_a) -> Eigen::Vector3d {
                  return R_b_from_a.matrix() * r_a.coordinates();
                });
  agree &= time(
      "quaternion product", two_quaternions, multiply,
      [](const auto& q_c_from_b, const auto& q_b_from_a) { return q_c_from_b.eigen() * q_b_from_a.eigen(); });
  agree &= time(
      "rate chain of three", three_rates,
      [](const auto& w_ab_b, const auto& w_bc_c, const auto& w_cd_d, const auto& R_c_from_b,
         const auto& R_d_from_c) { return R_d_from_c * (R_c_from_b * w_ab_b + w_bc_c) + w_cd_d; },
      [](const auto& w_ab_b, const auto& w_bc_c, const auto& w_cd_d, const auto& R_c_from_b,
         const auto& R_d_from_c) -> Eigen::Vector3d {
        const Eigen::Vector3d w_ac_c = R_c_from_b.matrix() * w_ab_b.coordinates() + w_bc_c.coordinates();
        return R_d_from_c.matrix() * w_ac_c + w_cd_d.coordinates();
      });
  agree &= time(
      "Rdot = R [w]x", rotation_and_rate,
      [](const auto& R_a_from_b, const auto& w_ab_b) { return rate(R_a_from_b, w_ab_b); },
      [](const auto& R_a_from_b, const auto& w_ab_b) -> Eigen::Matrix3d {
        const Eigen::Vector3d& w = w_ab_b.coordinates();
        Eigen::Matrix3d hat;
        hat << 0.0, -w.z(), w.y(), w.z(), 0.0, -w.x(), -w.y(), w.x(), 0.0;
        return R_a_from_b.matrix() * hat;
      });
  agree &= time(
      "Euler's equation", body,
      [](const auto& J_b, const auto& w_ab_b, const auto& torque_b) { return euler(J_b, w_ab_b, torque_b); },
      [](const auto& J_b, const auto& w_ab_b, const auto& torque_b) -> Eigen::Vector3d {
        const Eigen::Vector3d& w = w_ab_b.coordinates();
        return J_b.inverse_matrix() * (torque_b.coordinates() - w.cross(J_b.matrix() * w));
      });
  agree &= time(
      "exp to quaternion", rotation_vector_of, [](const auto& theta_ab) { return exp_quaternion(theta_ab); },
      [&](const auto& theta_ab) { return Eigen::Quaterniond(eigen_turn(theta_ab)); });
  agree &= time(
      "exp to DCM", rotation_vector_of, [](const auto& theta_ab) { return exp(theta_ab); },
      [&](const auto& theta_ab) { return eigen_turn(theta_ab).toRotationMatrix(); });
  agree &= time(
      "log of a quaternion", quaternion_of, [](const auto& q_a_from_b) { return log(q_a_from_b); },
      [](const auto& q_a_from_b) -> Eigen::Vector3d {
        const Eigen::AngleAxisd turn(q_a_from_b.eigen());
        return turn.angle() * turn.axis();
      });
  agree &= time(
      "DCM of a quaternion", quaternion_of, [](const auto& q_a_from_b) { return dcm(q_a_from_b); },
      [](const auto& q_a_from_b) { return q_a_from_b.eigen().toRotationMatrix(); });
  agree &= time(
      "quaternion of a DCM", rotation_of, [](const auto& R_a_from_b) { return quaternion(R_a_from_b); },
      [](const auto& R_a_from_b) { return Eigen::Quaterniond(R_a_from_b.matrix()); });
  return agree ? 0 : 1;
}
