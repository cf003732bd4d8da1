#pragma once
#ifndef STURM_SERIAL
#include <tbb/parallel_for.h>
#endif

namespace sturm {

/// Calls body(i) for all i from `first` to `last` − 1, shared out to threads; one after the other where the program is
/// built without threads (STURM_SERIAL, WebAssembly). Bodies of different i must not depend on each other.
template <class Index, class Body>
void parallel_for(Index first, Index last, const Body& body) {
#ifdef STURM_SERIAL
  for (Index i = first; i < last; ++i) body(i);
#else
  tbb::parallel_for(first, last, body);
#endif
}

}  // namespace sturm
