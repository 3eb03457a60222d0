// SPDX-License-Identifier: BSL-1.0
// Many motions at once, in their own threads, which are polled for their progress every tenth of a second.
#include <chrono>
#include <future>

#include "crossing.hpp"
#include "engine/ensemble/ensemble.hpp"
#include "looking.hpp"

namespace bindings {

namespace {

using matrix = py::array_t<double, py::array::c_style>;

engine::cast cast_of(engine::problem const& what, std::string const& method, bool in_lanes, engine::points<double> const& T) {
    py::gil_scoped_release const others_run;
    return engine::make_cast(what, method, T, in_lanes, [method, T](engine::problem const& one) {
        return engine::walker_of(engine::make_motion<double>(one, method, T));
    });
}

/// Walks of all members of an ensemble: (t, q, p, failures), q and p of members x points x dimension. `parameters` has a row of own
/// parameters for each member.
py::tuple walk_all(engine::cast const& all, matrix const& q0, std::string const& what, matrix const& other, matrix const& parameters,
                   hilger::index_type stride, int threads, py::object const& progress) {
    if (other.shape(0) != q0.shape(0) or parameters.shape(0) != q0.shape(0))
        hilger::error::raise<hilger::error::mismatch>("members have a row of each, and here are ", q0.shape(0), ", ", other.shape(0),
                                                      " and ", parameters.shape(0));
    std::vector<engine::member> from;
    using row = Eigen::Map<engine::vector<double> const>;
    for (py::ssize_t k = 0; k < q0.shape(0); ++k) {
        double const* const own = parameters.data() + k * parameters.shape(1);
        from.push_back({{row(q0.data(k, 0), q0.shape(1)), datum_named(what), row(other.data(k, 0), other.shape(1))},
                        {own, own + parameters.shape(1)}});
    }
    std::atomic<bool> stop = false;
    std::atomic<hilger::index_type> done = 0;
    auto running = std::async(std::launch::async, [&] { return engine::walk_all(all, from, stride, threads, stop, done); });
    bool interrupted = false;
    for (;;) {
        {
            py::gil_scoped_release const others_run;
            if (running.wait_for(std::chrono::milliseconds(100)) == std::future_status::ready) break;
        }
        if (interrupted) continue;
        try {
            interrupted = not goes_on(progress, static_cast<std::size_t>(done.load()));
        } catch (...) { // otherwise the threads would be awaited
            stop = true;
            throw;
        }
        if (interrupted) stop = true;
    }
    auto made = running.get();
    if (not interrupted) (void)goes_on(progress, static_cast<std::size_t>(done.load()));
    auto const cube = [&](std::vector<double>&& numbers) {
        return crossing<double>::array(std::move(numbers), 0).attr("reshape")(made.members, made.points, made.dimension);
    };
    return py::make_tuple(crossing<double>::array(std::move(made.t), 0), cube(std::move(made.q)), cube(std::move(made.p)), made.failures);
}

} // namespace

void add_ensembles(py::module_& m) {
    py::class_<engine::cast>(m, "Cast")
        .def(py::init([](engine::problem const& what, std::string const& method, bool in_lanes, py::tuple const& T) {
            return cast_of(what, method, in_lanes, points_from<double>(T));
        }))
        .def_property_readonly("lanes", [](engine::cast const& all) { return all.together ? all.together->width() : 1; });
    m.def("walk_all", &walk_all);
}

} // namespace bindings
