// A user's program with frames and space: TT is 69.184 s ahead of UTC in 2022.
#include <vectrix/space.hpp>

int main() {
  using namespace vectrix;
  return Epoch::from_utc("2022-04-14T00:00:00").tt(3) == "2022-04-14T00:01:09.184" ? 0 : 1;
}
