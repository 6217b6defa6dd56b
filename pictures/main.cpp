// pictures <name>: prints one picture. pictures --write <folder>: writes all of them.
// pictures <example> <table.csv>: prints what the example has written to its table.
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string_view>

#include "pictures.hpp"
#include "tables.hpp"

int main(int count, char** words) try {
  const std::map<std::string, std::string (*)(), std::less<>> all{
      {"coning", pictures::coning},
      {"drift", pictures::drift},
      {"work_precision", pictures::work_precision},
      {"polhodes", pictures::polhodes},
      {"passes", pictures::passes}};
  const std::string_view first = count > 1 ? words[1] : "";
  const auto picture = all.find(first);
  if (count == 2 && picture != all.end()) {
    std::cout << picture->second();
    return 0;
  }
  if (count == 3 && first != "--write") {
    if (const std::string drawn = pictures::of_table(first, words[2]); !drawn.empty()) {
      std::cout << drawn;
      return 0;
    }
  }
  if (count == 3 && first == "--write") {
    for (const auto& [name, draw] : all) {
      const std::string path = std::string(words[2]) + "/" + name + ".svg";
      std::ofstream file(path);
      file << draw();
      if (!file.flush()) throw std::runtime_error("cannot write " + path);
    }
    return 0;
  }
  std::cerr
      << "usage: pictures coning|drift|work_precision|polhodes|passes, or pictures --write <folder>, or\n"
         "       pictures "
      << pictures::drawn_examples() << " <table.csv>\n";
  return 2;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
