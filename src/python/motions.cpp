// SPDX-License-Identifier: BSL-1.0
// Motions, one at a time. A walk lets other threads of Python run, and checks every tenth of a second for an interrupt, which ends it.
#include "crossing.hpp"
#include "engine/ensemble/whole_steps.hpp"
#include "engine/machine_code/machine_code.hpp"
#include "engine/methods.hpp"
#include "hilger/trajectory/events.hpp"
#include "looking.hpp"

namespace bindings {

namespace {

template <class S>
py::tuple tuple_of(S const& t, engine::vector<S> const& q, engine::vector<S> const& p) {
    using with = crossing<S>;
    return py::make_tuple(with::word(t), with::array({q.data(), q.data() + q.size()}, 0), with::array({p.data(), p.data() + p.size()}, 0));
}

/// (t, q, p, reason for the stop, whether it was interrupted). `until`(t, q, p) is called at each point; true ends the walk there.
template <class S>
py::tuple walk(engine::motion<S> const& path, typename crossing<S>::given const& q0, std::string const& what,
               typename crossing<S>::given const& other, py::object const& progress, py::object const& until) {
    auto const from = initial_of<S>(q0, what, other);
    int const d = static_cast<int>(from.q0.size());
    std::vector<S> t, q, p;
    std::string stopped;
    bool interrupted = false;
    std::exception_ptr unexpected;
    auto const is_end = [&](S const& time, engine::vector<S> const& x, engine::vector<S> const& y) {
        if (until.is_none()) return false;
        py::gil_scoped_acquire const here;
        return until(*tuple_of<S>(time, x, y)).template cast<bool>();
    };
    {
        py::gil_scoped_release const others_run;
        looking look(progress);
        try {
            path.walk(from, [&](S const& time, engine::vector<S> const& x, engine::vector<S> const& y) {
                t.push_back(time);
                q.insert(q.end(), x.data(), x.data() + d);
                p.insert(p.end(), y.data(), y.data() + d);
                interrupted = not look(t.size() - 1);
                return not interrupted and not is_end(time, x, y);
            });
        } catch (hilger::error::exception const& why) {
            stopped = why.what();
            if (t.empty()) unexpected = std::current_exception(); // the first step failed
        } catch (py::error_already_set const& raised) {
            py::gil_scoped_acquire const here;
            if (not raised.matches(PyExc_KeyboardInterrupt)) throw;
            interrupted = true; // raised inside `until`
        }
    }
    if (unexpected) std::rethrow_exception(unexpected);
    if (not interrupted) interrupted = not goes_on(progress, t.size() - 1);
    return py::make_tuple(crossing<S>::array(std::move(t), 0), crossing<S>::array(std::move(q), d), crossing<S>::array(std::move(p), d),
                          stopped, interrupted);
}

/// The first fraction of a step at or after the zero of g, given its values at both ends: see hilger/trajectory/events.hpp.
template <class S>
S fraction_at_zero(std::function<S(S const&)> const& g, S const& was, S const& now) {
    if constexpr (std::numeric_limits<S>::is_exact)
        hilger::error::raise<hilger::error::invalid_parameter>("events are located by root finding, which rationals have not");
    else
        return hilger::detail::fraction_at_zero(g, was, now);
}

template <class S>
void add_motion(py::module_& m, char const* name) {
    using with = crossing<S>;
    using given = typename with::given;
    using number = typename with::word_type;
    using motion = engine::motion<S>;
    auto const state_of = [](number const& t, given const& q, given const& p) {
        return engine::state<S>{with::number(t), with::vector_of(q), with::vector_of(p)};
    };
    py::class_<motion>(m, name)
        .def(py::init([](engine::problem const& what, std::string const& method, py::tuple const& T) {
            return engine::make_motion<S>(what, method, points_from<S>(T));
        }))
        .def("walk", &walk<S>)
        .def("times", [](motion const& path) { return with::array(path.times(), 0); })
        .def("between",
             [](motion const& path, given const& first, given const& last, std::vector<given> const& guess) {
                 auto const a = with::vector_of(first), b = with::vector_of(last);
                 std::vector<engine::vector<S>> near;
                 for (given const& x : guess) near.push_back(with::vector_of(x));
                 auto const found = interruptible([&](std::stop_token const& stop) { return path.between(a, b, near, stop); });
                 auto const array = [&](std::vector<engine::vector<S>> const& states) {
                     std::vector<S> all;
                     for (auto const& x : states) all.insert(all.end(), x.data(), x.data() + x.size());
                     return with::array(std::move(all), static_cast<int>(a.size()));
                 };
                 return py::make_tuple(array(found.q), array(found.p), found.warning);
             })
        .def("residual",
             [](motion const& path, given const& q0, std::string const& what, given const& other, std::vector<given> const& positions,
                std::vector<given> const& momenta, bool absolute) {
                 auto const from = initial_of<S>(q0, what, other);
                 std::vector<engine::vector<S>> q, p;
                 for (given const& x : positions) q.push_back(with::vector_of(x));
                 for (given const& x : momenta) p.push_back(with::vector_of(x));
                 py::gil_scoped_release const others_run;
                 S const worst = path.residual(from, q, p, absolute);
                 py::gil_scoped_acquire const here;
                 return with::word(worst);
             })
        .def("energy", [state_of](motion const& path, number const& t, given const& q, given const& p,
                                  given const& near) { return with::word(path.energy(state_of(t, q, p), with::vector_of(near))); })
        .def_static("fraction_at_zero",
                    [](py::function const& g, number const& was, number const& now) {
                        auto const value = [&](S const& fraction) { return with::number(g(with::word(fraction)).template cast<number>()); };
                        return with::word(fraction_at_zero<S>(value, with::number(was), with::number(now)));
                    })
        .def("between_states", [state_of](motion const& path, number const& t0, given const& q0, given const& p0, number const& t1,
                                          given const& q1, given const& p1, number const& t) {
            auto const x = path.between_states(state_of(t0, q0, p0), state_of(t1, q1, p1), with::number(t));
            return py::make_tuple(with::array({x.q.data(), x.q.data() + x.q.size()}, 0),
                                  with::array({x.p.data(), x.p.data() + x.p.size()}, 0));
        });
}

/// The same walk by steps compiled to machine code as a whole; `path` makes the first step if needed. None without such code, or when a
/// step fails.
py::object walk_in_whole_steps(engine::motion<double> const& path, engine::problem const& what, std::string const& method,
                               py::tuple const& points, crossing<double>::given const& q0, std::string const& other_is,
                               crossing<double>::given const& other, py::object const& progress) {
    auto const T = points_from<double>(points);
    auto const from = initial_of<double>(q0, other_is, other);
    auto const alone = [&] { return [&](auto const& start, auto const& keep) { path.walk(start, keep); }; };
    std::optional<engine::states_in_whole_steps> made;
    {
        py::gil_scoped_release const others_run;
        looking look(progress);
        made = engine::walk_in_whole_steps(what, method, T, from, alone,
                                           [&](hilger::index_type done) { return look(static_cast<std::size_t>(done)); });
    }
    if (not made) return py::none();
    if (not made->interrupted) made->interrupted = not goes_on(progress, made->t.size() - 1);
    int const d = static_cast<int>(from.q0.size());
    using with = crossing<double>;
    return py::make_tuple(with::array(std::move(made->t), 0), with::array(std::move(made->q), d), with::array(std::move(made->p), d), "",
                          made->interrupted);
}

} // namespace

void add_motions(py::module_& m) {
    add_motion<double>(m, "Motion");
    add_motion<hilger::Q>(m, "ExactMotion");
    add_motion<hilger::float50>(m, "MotionIn50Digits");
    m.def("walk_in_whole_steps", &walk_in_whole_steps);
    m.def("set_machine_code", [](std::string const& how) {
        using engine::machine_code;
        if (how != "on" and how != "off" and how != "at once")
            hilger::error::raise<hilger::error::invalid_parameter>("machine code is \"on\", \"off\" or \"at once\", and not \"", how, '"');
        engine::set_machine_code(how == "on" ? machine_code::on : how == "off" ? machine_code::off : machine_code::at_once);
    });
    m.def("formulas_in_machine_code", &engine::formulas_in_machine_code);
    py::list methods;
    for (auto const& one : engine::all_methods()) methods.append(one.name);
    m.attr("methods") = methods;
    m.def("list_of_methods", [] {
        std::ostringstream out;
        engine::list_methods(out);
        return out.str();
    });
    m.def("solve_accurately", [](engine::problem const& what, double a, double b, crossing<double>::given const& q0, bool between,
                                 crossing<double>::given const& other, double wanted, double relative, double longest_step) {
        auto const x = crossing<double>::vector_of(q0), y = crossing<double>::vector_of(other);
        hilger::interval<double> const I{a, b};
        auto made = interruptible([&](std::stop_token const& stop) {
            hilger::accuracy const goal{wanted, longest_step, stop, relative};
            return between ? engine::solve_accurately(what, I, hilger::boundary_values<engine::vector<double>>{x, y}, goal)
                           : engine::solve_accurately(what, I, hilger::initial_velocity<engine::vector<double>>{x, y}, goal);
        });
        auto const rows = [&](auto const& states) {
            std::vector<double> numbers;
            for (auto const& at : states) numbers.insert(numbers.end(), at.data(), at.data() + at.size());
            return crossing<double>::array(std::move(numbers), static_cast<int>(x.size()));
        };
        return py::make_tuple(crossing<double>::array(std::move(made.t), 0), rows(made.q), rows(made.p), made.method, made.error);
    });
}

} // namespace bindings
