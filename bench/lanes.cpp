/// Times laws of doubles, and of as many doubles at once as the machine's registers hold, on the same
/// numbers. One line a law: the lanes, the law, ns an item of doubles, ns an item of lanes, and the median
/// ratio of the two.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <random>
#include <tuple>
#include <vectrix/dynamics/euler.hpp>
#include <vectrix/frames/simd.hpp>
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

/// The numbers of an item, or those of several items, one a lane.
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
    } else if constexpr (requires { result.matrix(); }) {
      return result.matrix();
    } else {
      return result.coordinates();
    }
  }

  using Operands = std::invoke_result_t<Make, Numbers<S>&>;
  Law law_;
  std::vector<Operands> operands_;
  using Result = detail::Evaluated<decltype(std::apply(std::declval<Law>(), std::declval<Operands>()))>;
  std::vector<Result> results_;
};

double seconds(auto& sweep, long calls) {
  const auto start = Clock::now();
  for (long i = 0; i < calls; ++i) sweep.run();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Rounds of one batch of each, in random order: what slows the machine slows both.
template <class Make, class Law> bool time(const char* name, const Make& make, const Law& law) {
  Sweep<double, Make, Law> one(make, law);
  Sweep<Lanes, Make, Law> many(make, law);
  const auto alone = one.numbers();
  const auto together = many.numbers();
  double difference = 0.0;
  for (std::size_t i = 0; i < alone.size(); ++i)
    difference = std::max(difference, std::abs(alone[i] - together.at(i)));

  constexpr long probe = 100;
  seconds(one, probe);
  const long calls = 1 + static_cast<long>(round_ns / (1e9 * seconds(one, probe) / probe));
  std::mt19937 generator(20240229);
  std::vector<double> ratios(rounds), one_ns(rounds), many_ns(rounds);
  const double per_item = 1e9 / static_cast<double>(calls) / static_cast<double>(items);
  for (std::size_t i = 0; i < rounds; ++i) {
    const bool one_first = generator() % 2 == 0;
    const double first = one_first ? seconds(one, calls) : seconds(many, calls);
    const double second = one_first ? seconds(many, calls) : seconds(one, calls);
    one_ns[i] = per_item * (one_first ? first : second);
    many_ns[i] = per_item * (one_first ? second : first);
    ratios[i] = one_ns[i] / many_ns[i];
  }
  std::printf("%zu\t%s\t%.2f\t%.2f\t%.2f\n", Lanes::size(), name, median(one_ns), median(many_ns),
              median(ratios));
  if (difference <= same) return true;
  std::fprintf(stderr, "lanes: %s: doubles and lanes differ by %g\n", name, difference);
  return false;
}

}  // namespace
}  // namespace bench

int main() {
  using namespace bench;
  const auto multiply = []<class Left, class Right>(const Left& left, const Right& right)
      -> detail::Evaluated<detail::ProductOf<const Left&, const Right&>> { return left * right; };
  bool agree = time(
      "DCM product",
      [](auto& n) {
        return std::tuple{n.rotation(C{}, B{}), n.rotation(B{}, A{})};
      },
      multiply);
  agree &= time(
      "DCM on a vector",
      [](auto& n) {
        return std::tuple{n.rotation(B{}, A{}), vector<si::length>(in<A>, n.column())};
      },
      multiply);
  agree &= time(
      "quaternion product",
      [](auto& n) {
        return std::tuple{n.quaternion(C{}, B{}), n.quaternion(B{}, A{})};
      },
      multiply);
  agree &= time(
      "rate chain of three",
      [](auto& n) {
        return std::tuple{n.rate(B{}, A{}), n.rate(C{}, B{}), n.rate(D{}, C{}), n.rotation(C{}, B{}),
                          n.rotation(D{}, C{})};
      },
      [](const auto& w_ab_b, const auto& w_bc_c, const auto& w_cd_d, const auto& R_c_from_b,
         const auto& R_d_from_c) { return R_d_from_c * (R_c_from_b * w_ab_b + w_bc_c) + w_cd_d; });
  agree &= time(
      "Rdot = R [w]x",
      [](auto& n) {
        return std::tuple{n.rotation(A{}, B{}), n.rate(B{}, A{})};
      },
      [](const auto& R_a_from_b, const auto& w_ab_b) { return rate(R_a_from_b, w_ab_b); });
  agree &= time(
      "Euler's equation",
      [](auto& n) {
        const auto v = n.column();
        using S = typename decltype(n.column())::Scalar;
        const detail::Square<S> J =
            (S(1) + v.squaredNorm()) * detail::Square<S>::Identity() - v * v.transpose();
        return std::tuple{trust_inertia(in<B>, J), n.rate(B{}, A{}), vector<si::torque>(in<B>, n.column())};
      },
      [](const auto& J_b, const auto& w_ab_b, const auto& torque_b) { return euler(J_b, w_ab_b, torque_b); });
  agree &= time(
      "exp to quaternion",
      [](auto& n) {
        return std::tuple{rotation_vector(of<B>, relative_to<A>, vector<si::angle>(in<B>, n.column()))};
      },
      [](const auto& theta_ab) { return exp_quaternion(theta_ab); });
  agree &= time(
      "exp to DCM",
      [](auto& n) {
        return std::tuple{rotation_vector(of<B>, relative_to<A>, vector<si::angle>(in<B>, n.column()))};
      },
      [](const auto& theta_ab) { return exp(theta_ab); });
  agree &= time(
      "log of a quaternion", [](auto& n) { return std::tuple{n.quaternion(A{}, B{})}; },
      [](const auto& q_a_from_b) { return log(q_a_from_b); });
  agree &= time(
      "DCM of a quaternion", [](auto& n) { return std::tuple{n.quaternion(A{}, B{})}; },
      [](const auto& q_a_from_b) { return dcm(q_a_from_b); });
  agree &= time(
      "quaternion of a DCM", [](auto& n) { return std::tuple{n.rotation(A{}, B{})}; },
      [](const auto& R_a_from_b) { return quaternion(R_a_from_b); });
  return agree ? 0 : 1;
}
