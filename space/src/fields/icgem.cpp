#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <vectrix/frames/errors.hpp>

#include "../files/text_file.hpp"
#include "gravity_model.hpp"

namespace vectrix::detail {
namespace {

// Around the -4.8416e-4 of the Earth, with and without the permanent tide, which makes 4e-9, and of all
// years. Without normalization it is 5^1/2 times as much.
constexpr double least_oblateness = -4.85e-4, most_oblateness = -4.83e-4;
// By 0.1 m from the centre of mass: C10 = z/(3^1/2 a). The motion of the geocentre is a tenth of that.
constexpr double largest_of_degree_1 = 1e-8;

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

class IcgemReader {
 public:
  IcgemReader(const std::filesystem::path& file, int degree) : file_(file), degree_(degree) {}

  GravityModel read() {
    if (degree_ < 0) fail("the degree asked for is " + text(degree_));
    const auto content = read_lines(file_);
    if (!content) fail("cannot be read");
    bool in_head = true;
    for (const std::string& line : content->lines) {
      ++line_;
      const bool has_end = content->whole || line_ < content->lines.size();
      if (!has_end && !ends_with_its_line(line, line_ > 1 ? content->lines[line_ - 2] : "")) fail(truncated);
      const std::vector<std::string> words = words_of(line);
      if (words.empty()) continue;
      if (!in_head) {
        coefficient(words);
      } else if (words.front() == "end_of_head") {
        in_head = false;
        require_complete_head();
      } else if (words.size() > 1) {
        keyword(words);
      }
    }
    if (in_head) fail("there is no end_of_head");
    return {*mu_, *radius_, all_coefficients()};
  }

 private:
  // A line without a line end is whole if its end is no digit of S, which is read, but the last of the errors
  // that the line before has too.
  [[nodiscard]] static bool ends_with_its_line(const std::string& line, const std::string& before) {
    constexpr std::size_t up_to_S = 5;
    const std::size_t words = words_of(line).size();
    return words > up_to_S && words == words_of(before).size();
  }

  [[noreturn]] void fail(const std::string& reason) const {
    throw BadInput("Gravity field " + file_.string() + (line_ > 0 ? ", line " + text(line_) : "") + ": " +
                   reason);
  }

  // Fortran writes the exponent as d or D.
  [[nodiscard]] double number(std::string word) const {
    std::replace_if(
        word.begin(), word.end(), [](char c) { return c == 'd' || c == 'D'; }, 'e');
    const auto value = parse_number(word);
    if (!value || !std::isfinite(*value)) fail("'" + word + "' is not a finite number");
    return *value;
  }
  [[nodiscard]] int whole(const std::string& word) const {
    const double value = number(word);
    if (!(value == std::floor(value) && std::abs(value) < 1e5)) fail("'" + word + "' is no degree or order");
    return static_cast<int>(value);
  }

  // The head is free text in which some lines begin with a keyword.
  void keyword(const std::vector<std::string>& words) {
    const std::string &name = words[0], &value = words[1];
    if (name == "product_type") {
      once(name, has_product_);
      has_product_ = true;
      if (value != "gravity_field") fail("the product is a " + value);
    }
    if (name == "norm" && value != "fully_normalized") fail("the coefficients are " + value);
    if (name == "earth_gravity_constant" || name == "gravity_constant") {
      once(name, mu_.has_value());
      mu_ = of_the_earth(name, value, 3.98e14, 3.99e14, " m^3/s^2");
    }
    if (name == "radius") {
      once(name, radius_.has_value());
      radius_ = of_the_earth(name, value, 6.35e6, 6.39e6, " m");
    }
    if (name == "max_degree") {
      once(name, max_degree_.has_value());
      max_degree_ = whole(value);
      if (*max_degree_ < degree_) {
        fail("the model ends at degree " + text(*max_degree_) + ", " + text(degree_) + " is asked for");
      }
    }
  }
  void once(const std::string& name, bool before) const {
    if (before) fail(name + " stands twice");
  }
  // In other units, or of another body, it is far from these values.
  [[nodiscard]] double of_the_earth(const std::string& name, const std::string& word, double least,
                                    double most, const char* unit) const {
    const double value = number(word);
    if (!(value >= least && value <= most)) {
      fail("the " + name + " is " + text(value) + ", that of the Earth is from " + text(least) + " to " +
           text(most) + unit);
    }
    return value;
  }
  void require_complete_head() const {
    if (!has_product_) fail("the head has no product_type");
    if (!mu_) fail("the head has no earth_gravity_constant");
    if (!radius_) fail("the head has no radius");
    if (!max_degree_) fail("the head has no max_degree");
  }

  void coefficient(const std::vector<std::string>& words) {
    if (words[0] != "gfc") {
      fail("'" + words[0] + "' is not supported, only gfc: coefficients that do not depend on time");
    }
    if (words.size() < 5) fail("degree, order, C and S are expected");
    const int n = whole(words[1]), m = whole(words[2]);
    if (n < 0 || m < 0 || m > n) fail("there is no order " + text(m) + " of degree " + text(n));
    if (n > *max_degree_) fail("the degree " + text(n) + " exceeds max_degree");
    const double C = number(words[3]), S = number(words[4]);
    if (m == 0 && S != 0.0) fail("S of order 0 is " + text(S));
    if (n == 0 && !(C > 0.999 && C < 1.001)) fail("C of degree 0 is " + text(C) + ", not 1");
    if (n > 0 && !(std::abs(C) < 1.0 && std::abs(S) < 1.0)) {
      fail("the coefficients " + text(C) + " and " + text(S) + " of degree " + text(n) + " are not below 1");
    }
    if (n == 2 && m == 0 && !(C >= least_oblateness && C <= most_oblateness)) {
      fail("C of degree 2 and order 0 is " + text(C) + ", that of the Earth, fully normalized, is from " +
           text(least_oblateness) + " to " + text(most_oblateness));
    }
    if (n == 1 && !(std::abs(C) <= largest_of_degree_1 && std::abs(S) <= largest_of_degree_1)) {
      fail("the coefficients " + text(C) + " and " + text(S) + " of degree 1 are more than " +
           text(largest_of_degree_1) + ": the origin is not the centre of mass");
    }
    if (n > degree_) return;
    if (!found_.insert({{n, m}, {C, S}}).second) {
      fail("degree " + text(n) + " and order " + text(m) + " stand twice");
    }
  }

  // The terms of degree 0 and 1 may be left out: they are 1, and 0 about the centre of mass.
  [[nodiscard]] Harmonics all_coefficients() {
    line_ = 0;
    for (int n = 2; n <= degree_; ++n) {
      for (int m = 0; m <= n; ++m) {
        if (!found_.contains({n, m})) {
          fail("the coefficients of degree " + text(n) + " and order " + text(m) + " are missing");
        }
      }
    }
    found_.insert({{0, 0}, {1.0, 0.0}});
    Harmonics all(degree_);
    for (const auto& [place, pair] : found_) all.add(place.first, place.second, pair);
    return all;
  }

  const std::filesystem::path& file_;
  int degree_;
  std::size_t line_ = 0;
  std::optional<double> mu_, radius_;
  std::optional<int> max_degree_;
  bool has_product_ = false;
  std::map<std::pair<int, int>, Harmonics::Pair> found_;  // by degree and order
};

}  // namespace

GravityModel read_icgem(const std::filesystem::path& file, int degree) {
  return IcgemReader(file, degree).read();
}

}  // namespace vectrix::detail
