#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

#include <vectrix/dynamics/ode/elapsed_time.hpp>
#include <vectrix/dynamics/ode/stages.hpp>
#include <vectrix/frames/export.hpp>

namespace vectrix::ode {

/// What a step of an integrator came to: a step towards `until`, the step that reaches it, or a failure that
/// leaves the state as it was. `too_short`: the error stays too large with the shortest step that changes the
/// time. `not_finite`: the rate at the state is infinite or not a number, or one of the shortest step is.
enum class Advance { stepped, reached, too_short, not_finite };

/// A right-hand side of N components, ydot = f(t, y). N may be std::dynamic_extent.
template <class F, std::size_t N>
concept Rates = std::invocable<F&, double, std::span<const double, N>, std::span<double, N>>;

namespace detail {

// What a RungeKutta refuses, with BadInput. It knows no type, so it is compiled once.
VECTRIX_EXPORT void require_tolerances(double relative, std::span<const double> absolute);
VECTRIX_EXPORT void require_start(double t, std::span<const double> y, double first_step);
VECTRIX_EXPORT void require_size(const char* call, const char* what, std::size_t size, std::size_t wanted);
[[noreturn]] VECTRIX_EXPORT void refuse_end(double time, double until);
[[noreturn]] VECTRIX_EXPORT void refuse_longest(double longest);
[[noreturn]] VECTRIX_EXPORT void refuse_time(double t, double before, double time);
[[noreturn]] VECTRIX_EXPORT void refuse_no_step(const char* call, double time);

}  // namespace detail

/// One step after another of an embedded explicit Runge-Kutta pair, with the right-hand side inlined. A step
/// is accepted if the estimated error of each component is at most relative * |y| + absolute. A step in which
/// anything is infinite or not a number is halved.
///
///     RungeKutta<Verner9, 7, F> method(f, 1e-10, absolute);
///     method.start(t, y);
///     while (method.step(until) == Advance::stepped) {}
///
/// The step to `until` is shortened to end there, never lengthened, and the length before that is remembered:
/// start(t, y, method.next_step()) carries it over a discontinuity. Allocates nothing if N is fixed. An
/// exception of the right-hand side passes through. Times are counted from
/// the start, or from the last `until` reached, with the rounding error of their sum. Throws BadInput for
/// tolerances, times and lengths that are not finite or have the wrong sign.
template <class Table, std::size_t N, Rates<N> F> class RungeKutta {
 public:
  using State = std::span<const double, N>;
  static constexpr std::size_t degree = Table::degree;

  RungeKutta(F rates, double relative_tolerance, State absolute_tolerances)
      : rates_(std::move(rates)),
        size_(absolute_tolerances.size()),
        relative_(relative_tolerance),
        absolute_(size_),
        y_(size_),
        before_(size_),
        stage_(size_),
        errors_(size_),
        k_(size_) {
    detail::require_tolerances(relative_, absolute_tolerances);
    for (std::size_t c = 0; c < absolute_.width(); ++c)
      absolute_[c] = c < size_ ? absolute_tolerances[c] : 1.0;
  }

  /// Begins at (t, y), without a memory of earlier rates. The length of the first step is chosen, unless
  /// given.
  void start(double t, State y, double first_step = 0.0) {
    detail::require_size("::start", "the state", y.size(), size_);
    detail::require_start(t, y, first_step);
    std::copy(y.begin(), y.end(), y_.data());
    origin_ = t;
    until_ = std::numeric_limits<double>::infinity();
    elapsed_ = {};
    step_ = 0.0;
    next_step_ = first_step;
    rate_known_ = dense_ = false;
  }

  /// One accepted step, at most to `until` and at most as long as `longest`.
  Advance step(double until, double longest = std::numeric_limits<double>::infinity()) {
    const double end = until - origin_, remaining = elapsed_.remaining(end);
    if (!(remaining > 0.0 && std::isfinite(until))) [[unlikely]]
      detail::refuse_end(time(), until);
    if (!(longest > 0.0)) [[unlikely]]
      detail::refuse_longest(longest);
    until_ = until;
    step_ = 0.0;
    find_rate();
    k_[0] = k_[Table::stages];
    k_.pack(0);
    for (std::size_t c = 0; c < size_; ++c)
      if (!std::isfinite(k_[0][c])) return Advance::not_finite;
    if (!(next_step_ > 0.0)) next_step_ = first_step(std::min(remaining, longest));
    Advance failure = Advance::too_short;
    bool rejected = false;
    while (true) {
      const auto [h, last, too_short] = elapsed_.next(std::min(next_step_, longest), end);
      if (too_short) return failure;
      const double error = attempt(h);
      const bool finite = std::isfinite(error);
      const double factor = finite ? safety * std::pow(error, -1.0 / (Table::error_order + 1)) : 0.5;
      if (!(error <= 1.0)) {
        next_step_ = h * std::max(factor, least_factor);
        failure = finite ? Advance::too_short : Advance::not_finite;
        rejected = true;
        ++rejections_;
        continue;
      }
      const double proposed = h * (rejected ? std::min(factor, 1.0) : std::min(factor, largest_factor));
      next_step_ = last && !rejected ? std::max(next_step_, proposed) : proposed;
      accept(h, last);
      return last ? Advance::reached : Advance::stepped;
    }
  }

  [[nodiscard]] double time() const { return time_of(0.0); }
  [[nodiscard]] State state() const { return State(y_.data(), size_); }
  /// The rate at the end of the step; the next step needs it too.
  [[nodiscard]] State rate() {
    find_rate();
    return State(k_[Table::stages].data(), size_);
  }
  /// Length the next step would have if no end were near.
  [[nodiscard]] double next_step() const { return next_step_; }
  [[nodiscard]] F& rates() { return rates_; }
  [[nodiscard]] const F& rates() const { return rates_; }
  [[nodiscard]] std::size_t rejections() const { return rejections_; }
  /// The component with the largest error in the last attempt, in units of its tolerance.
  [[nodiscard]] std::size_t worst_component() const { return worst_; }

  /// The state at a time within the last step: an interpolant of the order of the method. The first call
  /// after a step evaluates the stages it needs. Throws BadInput outside that step, and after a failed one.
  void interpolate(double t, std::span<double, N> y) {
    const double theta = 1.0 + ((t - origin_) - elapsed_.sum - elapsed_.rest) / step_;
    const double slack = 4.0 * epsilon * (1.0 + std::abs(t) / step_);
    require_step("::interpolate");
    if (!(theta >= -slack && theta <= 1.0 + slack)) [[unlikely]]
      detail::refuse_time(t, time_of(-step_), time());
    detail::require_size("::interpolate", "the state", y.size(), size_);
    polynomial();
    for (std::size_t c = 0; c < size_; ++c) {
      double sum = 0.0;
      for (std::size_t p = degree; p-- > 0;) sum = theta * (sum + terms_[p][c]);
      y[c] = before_[c] + sum;
    }
  }

  /// The same interpolant as numbers, term p of component c at [(p - 1) * N + c]:
  ///     y(t) = y_before + sum_p term_p theta^p,  theta = (t - t_before) / step,  p = 1 to `degree`.
  /// Throws BadInput after a failed step, and for another number of terms.
  void terms(std::span<double> terms) {
    require_step("::terms");
    detail::require_size("::terms", "the interpolant", terms.size(), degree * size_);
    polynomial();
    for (std::size_t p = 0; p < degree; ++p)
      std::copy(terms_[p].data(), terms_[p].data() + size_, terms.data() + p * size_);
  }

 private:
  void require_step(const char* call) const {
    if (!(step_ > 0.0)) [[unlikely]]
      detail::refuse_no_step(call, time());
  }

  static constexpr double epsilon = std::numeric_limits<double>::epsilon();
  static constexpr double safety = 0.8;  // with 0.9 a fifth of the steps of a tumbling body are rejected
  static constexpr double least_factor = 0.1;
  static constexpr double largest_factor = 5.0;
  using Numbers = detail::Numbers<N>;
  using Stages = detail::Stages<N, Table::all_stages>;
  using Group = typename Stages::Group;

  [[nodiscard]] double time_of(double since) const {
    return std::min(origin_ + (elapsed_.sum + (elapsed_.rest + since)), until_);
  }

  void evaluate(double t, const Numbers& y, Numbers& ydot) {
    rates_(t, State(y.data(), size_), std::span<double, N>(ydot.data(), size_));
  }

  void find_rate() {
    if (rate_known_) return;
    evaluate(time(), y_, k_[Table::stages]);
    k_.pack(Table::stages);
    rate_known_ = true;
  }

  template <std::size_t I, std::size_t J, class Packed>
  [[gnu::always_inline]] static void add(Group& sum, const Packed& k, std::size_t c) {
    if constexpr (Table::a[I][J] != 0.0) sum += Table::a[I][J] * k.group(J, c);
  }
  template <std::size_t I, std::size_t... J>
  [[gnu::always_inline]] void evaluate_stage(const Numbers& from, double t, double h,
                                             std::index_sequence<J...>) {
    const auto& k = k_.packed();
    auto&& begin = Stages::row(from);
    auto&& stage = Stages::row(stage_);
    for (std::size_t c = 0, width = from.width(); c < width; c += Stages::group_size) {
      Group sum{};
      (add<I, J>(sum, k, c), ...);
      Stages::store(stage, c, Stages::load(begin, c) + h * sum);
    }
    evaluate(std::min(t + Table::c[I] * h, until_), stage_, k_[I]);
    k_.pack(I);
  }
  template <std::size_t First, std::size_t... I>
  [[gnu::always_inline]] void evaluate_stages(const Numbers& from, double t, double h,
                                              std::index_sequence<I...>) {
    (evaluate_stage<First + I>(from, t, h, std::make_index_sequence<First + I>{}), ...);
  }

  template <std::size_t J, class Packed>
  [[gnu::always_inline]] static void weigh(Group& sum, Group& error, const Packed& k, std::size_t c) {
    if constexpr (Table::b[J] != 0.0) sum += Table::b[J] * k.group(J, c);
    if constexpr (Table::e[J] != 0.0) error += Table::e[J] * k.group(J, c);
  }
  /// Leaves the new state in stage_; returns the largest error of a component, in units of its tolerance.
  template <std::size_t... J>
  [[gnu::always_inline]] double weigh_stages(double h, std::index_sequence<J...>) {
    const auto& k = k_.packed();
    auto&& begin = Stages::row(y_);
    auto&& stage = Stages::row(stage_);
    auto&& errors = Stages::row(errors_);
    for (std::size_t c = 0, width = y_.width(); c < width; c += Stages::group_size) {
      Group sum{}, error{};
      (weigh<J>(sum, error, k, c), ...);
      Stages::store(stage, c, Stages::load(begin, c) + h * sum);
      Stages::store(errors, c, h * error);
    }
    for (std::size_t c = 0; c < y_.width(); ++c) {
      const double size = std::max(std::abs(y_[c]), std::abs(stage_[c]));
      errors_[c] =
          std::abs(errors_[c]) / (absolute_[c] + relative_ * size) + 0.0 * size;  // NaN if y overflows
    }
    double largest = 0.0;
    for (std::size_t c = 0; c < size_; ++c) {
      if (errors_[c] <= largest) continue;
      largest = errors_[c];  // not a number stays
      worst_ = c;
      if (!(largest < std::numeric_limits<double>::infinity())) break;
    }
    return largest;
  }

  double attempt(double h) {
    evaluate_stages<1>(y_, time(), h, std::make_index_sequence<Table::stages - 1>{});
    return weigh_stages(h, std::make_index_sequence<Table::stages>{});
  }

  void accept(double h, bool last) {
    std::swap(before_, y_);
    std::swap(y_, stage_);
    step_ = h;
    if (last) {
      origin_ = until_;
      elapsed_ = {};
    } else {
      elapsed_.add(h);
    }
    rate_known_ = dense_ = false;
  }

  /// A length whose error is near the tolerance, if the rates keep the ratio of their first change, |d f| /
  /// |f|, in all their derivatives. After E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential
  /// Equations I.
  double first_step(double longest) {
    constexpr double cautious = 0.01;
    const Numbers& rate = k_[0];
    double state_size = 0.0, rate_size = 0.0, change = 0.0;
    const auto scale = [&](std::size_t c) { return absolute_[c] + relative_ * std::abs(y_[c]); };
    for (std::size_t c = 0; c < size_; ++c) {
      state_size = std::max(state_size, std::abs(y_[c]) / scale(c));
      rate_size = std::max(rate_size, std::abs(rate[c]) / scale(c));
    }
    if (!(rate_size > 0.0)) return cautious * longest;
    const double trial = std::min(longest, cautious * std::max(state_size, 1.0) / rate_size);
    for (std::size_t c = 0; c < y_.width(); ++c) stage_[c] = y_[c] + trial * rate[c];
    evaluate(std::min(time() + trial, until_), stage_, k_[1]);
    for (std::size_t c = 0; c < size_; ++c)
      change = std::max(change, std::abs(k_[1][c] - rate[c]) / scale(c));
    const double frequency = change / (trial * rate_size);
    if (!(frequency > 0.0)) return std::min(longest, trial / cautious);
    // rate_size frequency^(order - 1) h^order = 1
    const double h = std::pow(frequency / rate_size, 1.0 / Table::order) / frequency;
    return std::min({longest, h, trial / cautious});
  }

  struct Cubic {
    Group first, second, third;
    [[nodiscard]] Group slope(double theta) const {
      return first + theta * (2.0 * second + theta * (3.0 * third));
    }
  };
  using Higher = std::array<Group, degree - 1>;  ///< the terms of theta^2 to theta^degree
  template <std::size_t J, std::size_t... P>
  [[gnu::always_inline]] static void add_weighted(Higher& sum, const Group& defect,
                                                  std::index_sequence<P...>) {
    ((sum[P] += Table::r[J][P] * defect), ...);
  }
  template <std::size_t J, class Packed>
  [[gnu::always_inline]] void add_defect(Higher& sum, const Cubic& cubic, const Packed& k,
                                         std::size_t c) const {
    if constexpr (Table::r[J][0] != 0.0) {
      const Group defect = step_ * k.group(J, c) - cubic.slope(Table::c[J]);
      add_weighted<J>(sum, defect, std::make_index_sequence<degree - 1>{});
    }
  }
  /// The weights r are large and cancel. They reproduce a cubic exactly, therefore they are applied to what
  /// the cubic through both ends and their rates leaves: that is small, and 0 at the ends.
  template <std::size_t... J> void fill_terms(std::index_sequence<J...>) {
    const auto& k = k_.packed();
    for (std::size_t c = 0; c < size_; c += Stages::group_size) {
      const Group first = step_ * k.group(0, c), last = step_ * k.group(Table::stages, c),
                  gain = Stages::load(Stages::row(y_), c) - Stages::load(Stages::row(before_), c);
      const Cubic cubic{first, 3.0 * gain - (2.0 * first + last), first + last - 2.0 * gain};
      Higher sum{cubic.second, cubic.third};
      (add_defect<J>(sum, cubic, k, c), ...);
      Stages::store(Stages::row(terms_[0]), c, first);
      for (std::size_t p = 0; p < sum.size(); ++p) Stages::store(Stages::row(terms_[p + 1]), c, sum[p]);
    }
  }
  void polynomial() {
    if (dense_) return;
    find_rate();
    const double begin = time_of(-step_);
    evaluate_stages<Table::stages + 1>(before_, begin, step_,
                                       std::make_index_sequence<Table::all_stages - Table::stages - 1>{});
    fill_terms(std::make_index_sequence<Table::all_stages>{});
    dense_ = true;
  }

  template <std::size_t... P>
  static std::array<Numbers, degree> make_terms(std::size_t size, std::index_sequence<P...>) {
    return {((void)P, Numbers(size))...};
  }

  F rates_;
  std::size_t size_;
  double relative_;
  Numbers absolute_;
  Numbers y_;
  Numbers before_;  ///< at the start of the last step
  Numbers stage_;
  Numbers errors_;  ///< of the last attempt, in units of their tolerances
  Stages k_;
  std::array<Numbers, degree> terms_ = make_terms(size_, std::make_index_sequence<degree>{});
  double origin_ = 0.0;  ///< of the elapsed time
  double until_ = 0.0;
  ElapsedTime elapsed_;  ///< from the origin to y_
  double step_ = 0.0;    ///< the last accepted one
  double next_step_ = 0.0;
  std::size_t rejections_ = 0;
  std::size_t worst_ = 0;
  bool rate_known_ = false;  ///< k_[stages] is the rate at y_
  bool dense_ = false;       ///< terms_ are those of the last step
};

}  // namespace vectrix::ode
