#pragma once

#include <compare>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include <vectrix/frames/operators.hpp>
#include <vectrix/space/time/time_scale.hpp>

namespace vectrix {

template <ScaleType Scale> class DateText;

namespace detail {

template <class Text>
concept TextLike = std::convertible_to<const Text&, std::string_view>;
template <class Text> inline constexpr bool no_instant = false;

/// A text in a scale, which compares with texts in the same scale and with plain ones. Of deleted operators
/// clang would list all those of std.
class ScaledText : public std::string {
 protected:
  explicit ScaledText(std::string text) : std::string(std::move(text)) {}

 private:
  template <class A, class B> friend bool operator==(const DateText<A>& a, const DateText<B>& b) {
    static_assert(std::is_same_v<A, B>, "texts of one scale compare; else the epochs");
    return std::string_view(a) == std::string_view(b);
  }
  template <class A, class B>
  friend std::strong_ordering operator<=>(const DateText<A>& a, const DateText<B>& b) {
    static_assert(std::is_same_v<A, B>, "texts of one scale compare; else the epochs");
    return std::string_view(a) <=> std::string_view(b);
  }
  template <class Scale, TextLike Other> friend Refused operator-(const DateText<Scale>&, const Other&) {
    static_assert(no_instant<Other>, "a text is no instant: subtract the epochs");
    return {};
  }
};

}  // namespace detail

/// The text of an instant in one scale, "2022-04-14T10:22:11.874999": a std::string that knows in which scale
/// it was written, though it does not show it. Epoch::from does not read it in another, and texts of two
/// scales do not compare.
template <ScaleType Scale> class DateText : public detail::ScaledText {
 public:
  /// A claim: the text was written in this scale.
  explicit DateText(std::string text, const Scale& = {}) : ScaledText(std::move(text)) {}
  template <class Written>
    requires(!std::same_as<Written, Scale>)
  explicit DateText(  // a text stays in the scale in which it was written: write the epoch again
      const DateText<Written>&, const Scale& = {}) = delete;

  static constexpr Scale written_in() { return {}; }
};

/// A text in UT1 keeps the UT1-TAI, or UT1-UTC, with which it was written. Epoch::from does not read it with
/// another.
template <> class DateText<scale::Ut1> : public detail::ScaledText {
 public:
  explicit DateText(std::string text, const scale::Ut1& written_in)
      : ScaledText(std::move(text)), written_in_(written_in) {}
  template <class Written>
  explicit DateText(  // a text stays in the scale in which it was written: write the epoch again
      const DateText<Written>&, const scale::Ut1&) = delete;

  [[nodiscard]] const scale::Ut1& written_in() const { return written_in_; }

 private:
  scale::Ut1 written_in_;
};

/// A text that is to be read in one scale: any text, but not one that was written in another scale.
template <ScaleType Scale> class DateTextView : public std::string_view {
 public:
  template <std::convertible_to<std::string_view> Text>
  DateTextView(const Text& text) : std::string_view(text) {}
  template <class Written>
    requires(!std::same_as<Written, Scale>)
  DateTextView(  // a text is read in the scale in which it was written
      const DateText<Written>&)
  = delete;
  template <class Number>
    requires std::is_arithmetic_v<Number>
        DateTextView(  // a text; of a number, Epoch::from_modified_julian_date(scale::utc, day)
            Number)
  = delete;
};

/// A text that is to be read in a scale which is known at run time only: any text, with the scale in which it
/// was written if its type has it.
class AnyDateText : public std::string_view {
 public:
  template <std::convertible_to<std::string_view> Text>
  AnyDateText(const Text& text) : std::string_view(text) {}
  template <class Written>
  AnyDateText(const DateText<Written>& text) : std::string_view(text), written_in_(text.written_in()) {}

  /// Nothing if it is not known.
  [[nodiscard]] const std::optional<TimeScale>& written_in() const { return written_in_; }

 private:
  std::optional<TimeScale> written_in_{};
};

}  // namespace vectrix
