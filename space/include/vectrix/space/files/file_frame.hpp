#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include <vectrix/frames/frame.hpp>
#include <vectrix/frames/trusted.hpp>
#include <vectrix/space/earth/eme2000.hpp>
#include <vectrix/space/earth/frames_of_date.hpp>
#include <vectrix/space/earth/teme.hpp>

namespace vectrix {
namespace detail {

inline constexpr const char* default_center = "EARTH";

}  // namespace detail

/// Claims which frame type a file means by a name. A message of CCSDS names the axes, and in an orbit their
/// centre: called<MarsInertial>("EME2000", "MARS BARYCENTER"). Capitals do not matter. Made by called(); the
/// frames of the Earth have standard names, and need no claim.
template <Frame F> class Called {
 public:
  Called(detail::Trusted, std::string name, std::string center)
      : name_(std::move(name)), center_(std::move(center)) {}

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::string& center() const { return center_; }

 private:
  std::string name_, center_;
};
template <Frame F> Called<F> called(std::string name, std::string center = detail::default_center) {
  return {detail::trusted, std::move(name), std::move(center)};
}

namespace detail {

enum class StandardFrame { none, gcrf, eme2000, itrf, teme, true_of_date, mean_of_date };

template <class F> inline constexpr StandardFrame standard_frame = StandardFrame::none;
template <> inline constexpr StandardFrame standard_frame<earth::Gcrf> = StandardFrame::gcrf;
template <> inline constexpr StandardFrame standard_frame<earth::Eme2000> = StandardFrame::eme2000;
template <> inline constexpr StandardFrame standard_frame<earth::Itrf> = StandardFrame::itrf;
template <> inline constexpr StandardFrame standard_frame<earth::Teme> = StandardFrame::teme;
template <> inline constexpr StandardFrame standard_frame<earth::TrueOfDate> = StandardFrame::true_of_date;
template <> inline constexpr StandardFrame standard_frame<earth::MeanOfDate> = StandardFrame::mean_of_date;

template <class F, class... Given> inline constexpr bool is_claim = false;
template <class F> inline constexpr bool is_claim<F> = standard_frame<F> != StandardFrame::none;
template <class F> inline constexpr bool is_claim<F, Called<F>> = true;

/// The result of a door that takes a frame by its standard name, or by called<F>("NAME").
template <class F, class Result, class... Given>
using Claimed = std::enable_if_t<is_claim<F, Given...>, Result>;
template <class F, class... Given> using Unclaimed = std::enable_if_t<!is_claim<F, Given...>, Refused>;

/// What is claimed of a name in a file: a frame type, by its standard name or by a given one.
struct FrameClaim {
  std::string type;
  StandardFrame standard;
  std::optional<std::string> name;
  std::string center;
};
template <Frame F> FrameClaim claim_of() {
  return {frame_name<F>(), standard_frame<F>, std::nullopt, default_center};
}
template <Frame F> FrameClaim claim_of(const Called<F>& called) {
  return {frame_name<F>(), standard_frame<F>, called.name(), called.center()};
}

/// Whether each of the claims is of a or of b, and the frames without a claim have standard names.
template <class A, class B, class... Given>
inline constexpr bool are_claims =
    !std::is_same_v<A, B> && ((std::is_same_v<Given, Called<A>> || std::is_same_v<Given, Called<B>>)&&...) &&
    (0 + ... + int{std::is_same_v<Given, Called<A>>}) <= 1 &&
    (0 + ... + int{std::is_same_v<Given, Called<B>>}) <= 1 &&
    (is_claim<A> || (std::is_same_v<Given, Called<A>> || ...)) &&
    (is_claim<B> || (std::is_same_v<Given, Called<B>> || ...));

/// The result of a door that takes two frames by their standard names, or by called<F>("NAME").
template <class A, class B, class Result, class... Given>
using ClaimedPair = std::enable_if_t<are_claims<A, B, Given...>, Result>;
template <class A, class B, class... Given>
using UnclaimedPair = std::enable_if_t<!are_claims<A, B, Given...>, Refused>;

/// The claim of F among those of several frames.
template <Frame F> FrameClaim claim_among() {
  return claim_of<F>();
}
template <Frame F, class First, class... Rest>
FrameClaim claim_among(const First& first, const Rest&... rest) {
  if constexpr (std::is_same_v<First, Called<F>>) {
    return claim_of<F>(first);
  } else {
    return claim_among<F>(rest...);
  }
}

}  // namespace detail
}  // namespace vectrix
