// compare_output <expected file> <program> <arguments>…: runs the program and compares its output with the
// file, line by line. The first line of the file, "# rel <number> abs <number>", gives the tolerance for
// numbers:
//     |printed - expected| <= abs + rel |expected|
// Everything else must be equal; blanks are ignored.
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

struct Tolerance {
  double relative = 0.0;
  double absolute = 0.0;
};

// One number, or one character between numbers. A digit after a letter, as in S1A, is not a number.
struct Token {
  std::string text;
  double value;
  bool number;
};

bool in_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::vector<Token> tokens(std::string_view line) {
  std::vector<Token> result;
  for (std::size_t at = 0; at < line.size();) {
    const char* const begin = line.data() + at;
    const std::size_t sign = line[at] == '-' ? 1 : 0;
    const bool digit =
        at + sign < line.size() && std::isdigit(static_cast<unsigned char>(line[at + sign])) != 0;
    if (digit && (at == 0 || !in_word(line[at - 1]))) {
      double value = 0.0;
      const char* const end = std::from_chars(begin, line.data() + line.size(), value).ptr;
      result.push_back({std::string(begin, end), value, true});
      at += result.back().text.size();
    } else if (std::isspace(static_cast<unsigned char>(line[at])) != 0) {
      ++at;
    } else {
      result.push_back({std::string(1, line[at]), 0.0, false});
      ++at;
    }
  }
  return result;
}

bool near(double printed, double expected, const Tolerance& tolerance) {
  return std::abs(printed - expected) <= tolerance.absolute + tolerance.relative * std::abs(expected);
}

// The difference between two lines, or nothing.
std::string difference(const std::string& printed, const std::string& expected, const Tolerance& tolerance) {
  const auto got = tokens(printed);
  const auto want = tokens(expected);
  const auto same = [&](const Token& a, const Token& b) {
    return a.number && b.number ? near(a.value, b.value, tolerance)
                                : a.text == b.text && a.number == b.number;
  };
  const auto [a, b] = std::mismatch(got.begin(), got.end(), want.begin(), want.end(), same);
  if (a == got.end() && b == want.end()) {
    return {};
  }
  return "'" + (a == got.end() ? "end of line" : a->text) + "' instead of '" +
         (b == want.end() ? "end of line" : b->text) + "'";
}

std::string quoted(std::string_view word) {
  std::string result = "'";
  for (const char c : word) {
    result += c == '\'' ? std::string{"'\\''"} : std::string(1, c);
  }
  return result + "'";
}

}  // namespace

int main(int count, char** words) {
  if (count < 3) {
    std::cerr << "usage: compare_output <expected file> <program> <arguments>...\n";
    return 2;
  }
  std::ifstream file(words[1]);
  std::string line;
  std::getline(file, line);
  Tolerance tolerance;
  std::string hash, rel, abs;
  if (!(std::istringstream(line) >> hash >> rel >> tolerance.relative >> abs >> tolerance.absolute) ||
      hash != "#" || rel != "rel" || abs != "abs") {
    std::cerr << words[1] << ": the first line must be '# rel <number> abs <number>'\n";
    return 2;
  }

  std::string command;
  for (int i = 2; i < count; ++i) {
    command += quoted(words[i]) + " ";
  }
  FILE* const pipe = popen(command.c_str(), "r");
  std::string output;
  std::array<char, 4096> buffer{};
  for (std::size_t n = 0; pipe != nullptr && (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
    output.append(buffer.data(), n);
  }
  const int status = pipe == nullptr ? -1 : pclose(pipe);

  std::istringstream printed(output);
  std::string got, want;
  for (int number = 2;; ++number) {
    const bool has_got = static_cast<bool>(std::getline(printed, got));
    const bool has_want = static_cast<bool>(std::getline(file, want));
    if (!has_got && !has_want) {
      break;
    }
    const std::string what = difference(has_got ? got : "", has_want ? want : "", tolerance);
    if (has_got != has_want || !what.empty()) {
      std::cerr << words[1] << ":" << number << ": " << what
                << "\n  printed:  " << (has_got ? got : "(nothing)")
                << "\n  expected: " << (has_want ? want : "(nothing)") << "\nThe whole output:\n"
                << output;
      return 1;
    }
  }
  if (status != 0) {
    std::cerr << command << "ended with status " << status << "\n";
    return 1;
  }
  return 0;
}
