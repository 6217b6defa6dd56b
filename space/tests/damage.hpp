#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>

namespace vectrix {

/// Damages texts, the same way in every run of a seed.
class Damage {
 public:
  explicit Damage(std::uint64_t seed) : random_(seed) {}

  /// One to three of: a bit flipped, a byte, a digit or an end of line put in place of another, a piece cut
  /// out, doubled or exchanged, the end cut off, a very long piece put in.
  std::string of(std::string text) {
    for (std::uint64_t k = below(3) + 1; k > 0; --k) change(text);
    return text;
  }
  std::uint64_t below(std::uint64_t count) { return random_() % count; }

 private:
  void change(std::string& text) {
    if (text.empty()) return;
    const std::size_t at = below(text.size()),
                      length = std::min<std::size_t>(below(40) + 1, text.size() - at);
    switch (below(10)) {
      case 0:
        text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
        break;
      case 1:
        text[at] = static_cast<char>(below(256));
        break;
      case 2:
      case 3:
        text[at] = "0123456789+-.eE naif="[below(21)];
        break;
      case 4:
        text[at] = "\0\n\r\t[]"[below(6)];
        break;
      case 5:
        text.erase(at, length);
        break;
      case 6:
        text.insert(at, text.substr(at, length));
        break;
      case 7:
        text.insert(below(text.size()), text.substr(at, length));
        break;
      case 8:
        text.resize(at);
        break;
      default:
        text.insert(at, std::string(below(8) == 0 ? 20000 : 300, "0 9\0\xff="[below(6)]));
    }
  }

  std::mt19937_64 random_;
};

}  // namespace vectrix
