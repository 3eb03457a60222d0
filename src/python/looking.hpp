// SPDX-License-Identifier: BSL-1.0
// Progress reports and checks for an interrupt during long computations.
#pragma once

#include <chrono>
#include <ctime>
#include <future>
#include <stop_token>

#include "bindings.hpp"

namespace bindings {

/// A clock in seconds, accurate to a few milliseconds and cheap: steps may take nanoseconds.
inline double coarse_now() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC_COARSE, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Reports progress, and checks for Ctrl-C. @returns whether to continue; other exceptions, of `progress` or of a signal handler, are
/// thrown
inline bool goes_on(py::object const& progress, std::size_t done) {
    try {
        if (not progress.is_none()) progress(done);
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        return true;
    } catch (py::error_already_set const& raised) {
        if (not raised.matches(PyExc_KeyboardInterrupt)) throw;
        return false;
    }
}

/// Calls goes_on every tenth of a second of a computation that has released the interpreter lock.
class looking {
public:
    explicit looking(py::object const& progress) : progress_(progress) {}
    bool operator()(std::size_t done) {
        if (coarse_now() - last_ < 0.1) return true;
        py::gil_scoped_acquire const here;
        bool const on = goes_on(progress_, done);
        last_ = coarse_now();
        return on;
    }

private:
    py::object const& progress_;
    double last_ = coarse_now();
};

/// The result of run(std::stop_token), in its own thread. An exception of a signal handler, as Ctrl-C, requests the stop and is thrown.
template <class Run>
auto interruptible(Run const& run) {
    std::stop_source stop;
    auto running = std::async(std::launch::async, [&] { return run(stop.get_token()); });
    for (;;) {
        {
            py::gil_scoped_release const others_run;
            if (running.wait_for(std::chrono::milliseconds(100)) == std::future_status::ready) break;
        }
        if (PyErr_CheckSignals() == 0) continue;
        stop.request_stop();
        py::gil_scoped_release const others_run;
        running.wait();
        break;
    }
    if (PyErr_Occurred() != nullptr) throw py::error_already_set();
    return running.get();
}

} // namespace bindings
