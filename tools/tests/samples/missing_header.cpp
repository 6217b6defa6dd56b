// A case that is refused because a header is missing
namespace missing_header {
// mistake: only a header that does not exist
// expect: no_such_header
#ifdef REPAIRED
#else
#include <vectrix/no_such_header.hpp>
#endif
}  // namespace missing_header
