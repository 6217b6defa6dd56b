#pragma once

#include <array>
#include <string>
#include <type_traits>
#include <vectrix/kinematics/named/frame.hpp>

namespace vectrix {

namespace detail {

template <char letter> inline constexpr bool is_letter = letter >= 'a' && letter <= 'z';

}  // namespace detail

/// Types that stand for one frame known at run time while a typed law is used: Dcm<Some<'b'>, Some<'a'>>. The
/// frame of the second must be inertial. The letters are a to z.
template <char letter>
  requires detail::is_letter<letter>
struct Some : moving_frame {
};
template <char letter>
  requires detail::is_letter<letter>
struct SomeInertial : inertial_frame {
};

namespace detail {

template <class F> struct LetterOf;
template <char letter> struct LetterOf<Some<letter>> : std::integral_constant<char, letter> {};
template <char letter> struct LetterOf<SomeInertial<letter>> : std::integral_constant<char, letter> {};

inline std::string are_two(NamedFrame one, NamedFrame other) {
  return in_quotes(one) + " and " + in_quotes(other) +
         (one.name() == other.name() ? " are frames of two graphs" : " are two frames");
}

inline void replace_all(std::string& text, const std::string& word, const std::string& by) {
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + by.size()))
    text.replace(at, word.size(), by);
}

/// Puts the name of a frame where a text has its type: to<B> becomes to "name".
inline void put_name(std::string& text, const std::string& type, const std::string& name) {
  for (const char* word : {"to", "from", "in", "of", "about", "relative_to", "observed_from"})
    for (const char* before : {"(", " "})
      replace_all(text, std::string{before} + word + "<" + type + ">",
                  std::string{before} + word + " " + in_quotes(name));
  replace_all(text, type, in_quotes(name));
}

/// The frames for which the letters stand while one law is used.
class Lent {
 public:
  /// A letter that has a frame already keeps it; if the other differs, it is counted.
  template <class F> void give(NamedFrame frame) {
    if (InertialFrame<F> && frame.motion() != FrameMotion::inertial)
      throw BadInput(in_quotes(frame) + " is a moving frame; the law needs an inertial one");
    give(LetterOf<F>::value, frame);
  }
  void give(char letter, NamedFrame frame) {
    const FrameRecord*& place = records_[static_cast<std::size_t>(letter - 'a')];
    if (place == nullptr) {
      place = &frame.record();
    } else if (place != &frame.record() && clashes_++ == 0) {
      one_ = place;
      other_ = &frame.record();
    }
  }
  NamedFrame operator[](char letter) const {
    const FrameRecord* record = records_[static_cast<std::size_t>(letter - 'a')];
    if (record == nullptr)
      throw BadInput(std::string{"no operand says which frame '"} + letter + "' of the result is");
    return NamedFrame{*record};
  }
  /// How often a letter would need two frames.
  int clashes() const { return clashes_; }
  std::string first_clash() const { return are_two(NamedFrame{*one_}, NamedFrame{*other_}); }

  /// A text about the letters, with the frames in their places.
  std::string named(std::string text) const {
    replace_all(text, "'> >", "'>>");  // as g++ writes the end of two templates
    for (char letter = 'a'; letter <= 'z'; ++letter)
      if (const FrameRecord* record = records_[static_cast<std::size_t>(letter - 'a')])
        for (const char* type : {"Some<'", "SomeInertial<'"})
          put_name(text, std::string{type} + letter + "'>", record->name);
    return text;
  }
  /// make(), which uses a typed law or door. In its errors the frames replace the letters.
  template <class Make> auto call(const Make& make) const {
    try {
      return make();
    } catch (const BadInput& error) {
      throw BadInput(named(error.what()));
    }
  }

 private:
  std::array<const FrameRecord*, 26> records_{};
  int clashes_ = 0;
  const FrameRecord *one_ = nullptr, *other_ = nullptr;
};

}  // namespace detail
}  // namespace vectrix
