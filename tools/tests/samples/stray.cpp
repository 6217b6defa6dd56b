// An error outside of every case
struct Metres {};

int length = Metres{};

namespace metres_for_a_number {
// mistake: metres where a number is wanted
// expect: Metres
#ifdef REPAIRED
Metres height;
#else
int height = Metres{};
#endif
}  // namespace metres_for_a_number
