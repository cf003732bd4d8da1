#pragma once
#include <pybind11/pybind11.h>

#include <functional>

namespace sturm {

/// Does `work` in a thread of its own and without Python's lock. Meanwhile the calling thread listens for Ctrl-C and
/// tells `progress` (None, or a function of the fraction done) about it, both some ten times a second. `work` reports
/// to the function that it gets, from any thread. Ctrl-C, or an exception of `progress`, ends it at its next report and
/// is then thrown here.
void do_watched(const pybind11::object& progress,
                const std::function<void(const std::function<void(double)>& report)>& work);

}  // namespace sturm
