#include "python/watched_work.h"

#include <atomic>
#include <chrono>
#include <future>

namespace sturm {

namespace py = pybind11;

namespace {

constexpr std::chrono::milliseconds interval{100};

/// Thrown inside of work that is no longer wanted.
struct Unwanted {};

bool is_done(const std::future<void>& work) {
  const py::gil_scoped_release release;
  return work.wait_for(interval) == std::future_status::ready;
}

/// Tells Python how far it is; its exceptions end the work.
void look_after_python(const py::object& progress, double fraction) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (!progress.is_none()) progress(fraction);
}

}  // namespace

void do_watched(const py::object& progress,
                const std::function<void(const std::function<void(double)>& report)>& work) {
  std::atomic<bool> unwanted{false};
  std::atomic<double> fraction{0.0};
  const std::function<void(double)> report = [&](double done) {
    if (unwanted) throw Unwanted{};
    fraction = done;
  };
  std::future<void> running = std::async(std::launch::async, [&] { work(report); });
  try {
    while (!is_done(running)) look_after_python(progress, fraction);
  } catch (...) {
    unwanted = true;
    const py::gil_scoped_release release;
    running.wait();
    throw;
  }
  running.get();
  look_after_python(progress, 1.0);
}

}  // namespace sturm
