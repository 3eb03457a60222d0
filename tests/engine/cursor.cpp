// SPDX-License-Identifier: BSL-1.0
// Cursors: in parts as at once, on equal steps and on given points as the library's own flows, and from checkpoints bit for bit.
#include <sstream>

#include <doctest/doctest.h>

#include "engine/methods.hpp"
#include "hilger/hilger.hpp"
#include "hilger/text/embedding.hpp"
#include "stated.hpp"

namespace cursor_tests {

using namespace hilger;
using engine::second_datum;
using testing::stated;
using vector = Eigen::VectorXd;

namespace {

constexpr index_type steps = 40;
engine::points<double> const equal{0.25, 0.0625, steps, {}};

engine::problem pendulums(int d) {
    return stated("sum(i, 0, " + std::to_string(d - 1) + ", v[i]^2/2 + cos(q[i])) - q[0]*q[" + std::to_string(d - 1) + "]/8", d);
}
engine::initial<double> from(int d, second_datum what = second_datum::velocity) {
    return {vector::LinSpaced(d, 0.5, 1.5), what, vector::Constant(d, 0.25)};
}
std::unique_ptr<engine::motion<double>> motion_of(engine::problem const& what, std::string const& method, engine::points<double> const& T) {
    auto made = engine::embedded_in_one_step(what, method, T);
    return made ? std::move(made) : engine::composed(what, method, T);
}
struct seen {
    std::vector<double> t;
    std::vector<vector> q, p;
    friend bool operator==(seen const&, seen const&) = default;
};
seen walked(engine::motion<double> const& motion, engine::initial<double> const& start) {
    seen all;
    motion.walk(start, [&](double t, vector const& q, vector const& p) {
        all.t.push_back(t);
        all.q.push_back(q);
        all.p.push_back(p);
        return true;
    });
    return all;
}
void add(seen& to, engine::state<double> const& x) {
    to.t.push_back(x.t);
    to.q.push_back(x.q);
    to.p.push_back(x.p);
}

} // namespace

TEST_CASE("a cursor that is advanced in parts is where a walk is, and has the mean velocity of the last step") {
    for (int const d : {1, 3, 4})
        for (char const* method : {"order-one", "mid-point", "mid-point+", "theta:0.3", "verlet", "blanes-moan-4", "kahan-li-8"})
            for (auto const& T : {equal, testing::uneven(steps)}) {
                CAPTURE(d);
                CAPTURE(method);
                auto const motion = motion_of(pendulums(d), method, T);
                REQUIRE(motion);
                seen const all = walked(*motion, from(d));
                REQUIRE(all.t == motion->times());
                auto const at = motion->begin(from(d));
                CHECK(at->velocity() == from(d).other);
                for (index_type const part : {1, 7, 1, 20, 100}) {
                    at->advance(part);
                    auto const k = static_cast<std::size_t>(at->number());
                    auto const x = at->state();
                    CHECK(std::tie(x.t, x.q, x.p) == std::tie(all.t[k], all.q[k], all.p[k]));
                    vector const mean = (all.q[k] - all.q[k - 1]) / (all.t[k] - all.t[k - 1]);
                    CHECK((at->velocity() - mean).cwiseAbs().maxCoeff() < 1e-13);
                }
                CHECK(at->number() == steps);
            }
}

TEST_CASE("what keeps the states may end a walk, and the cursor is there") {
    for (int const d : {2, 4}) {
        auto const motion = motion_of(pendulums(d), "mid-point", equal);
        auto const at = motion->begin(from(d));
        int told = 0;
        at->advance(steps, [&](double, vector const&, vector const&) { return ++told < 9; });
        CHECK(at->number() == 9);
        CHECK(at->state().t == motion->times()[9]);
    }
}

TEST_CASE("equal steps and given points are those of the library's own scales") {
    auto const what = pendulums(4);
    auto const L = what.lagrangian;
    vector const q = from(4).q0, p = from(4).other;
    auto const compare = [&](engine::points<double> const& T, auto const& scale) {
        seen own;
        for (auto const& [t, x, y] : embed(L, text::embedding_at(0.5)).along(scale, q, p)) add(own, {t, x, y});
        CHECK(walked(*motion_of(what, "mid-point", T), from(4, second_datum::momentum)) == own);
    };
    compare(equal, uniform(0.25, 0.0625, steps));
    auto const given = testing::uneven(steps);
    compare(given, time_scale<double>(given.given));
    engine::points<double> with_end = equal;
    with_end.last = 2.75;
    CHECK(motion_of(what, "verlet", with_end)->times().back() == 2.75);
}

TEST_CASE("a cursor continues from its checkpoint bit for bit") {
    for (int const d : {1, 4})
        for (char const* method : {"mid-point", "kahan-li-8+"}) {
            auto const motion = motion_of(pendulums(d), method, equal);
            auto const whole = motion->begin(from(d)), later = motion->begin(from(d));
            whole->advance(17);
            std::stringstream kept;
            REQUIRE(whole->save(kept));
            later->load(kept, "the text");
            CHECK(later->number() == 17);
            for (auto const* at : {&whole, &later}) (*at)->advance(steps);
            CHECK(later->state().q == whole->state().q);
            CHECK(later->state().p == whole->state().p);
            std::istringstream other("nothing");
            CHECK_THROWS_AS(later->load(other, "the text"), error::unreadable);
        }
}

TEST_CASE("the list of methods has those that there are") {
    auto const what = stated("v[0]^2/2 - q[0]^2/2", 1);
    for (auto const& one : engine::all_methods()) {
        bool const is_here = one.kind != engine::method_kind::structure and one.kind != engine::method_kind::two_ends and
                             one.kind != engine::method_kind::memory and one.name.find("gauss") == std::string::npos and
                             one.name.find("lobatto") == std::string::npos;
        CHECK_MESSAGE((motion_of(what, one.name, equal) != nullptr) == is_here, one.name);
    }
    CHECK(engine::method_names(what, engine::scalar_kind::rationals, false) ==
          std::vector<std::string>{"order-one", "order-one-left", "mid-point", "verlet"});
    CHECK(engine::method_names(what, engine::scalar_kind::machine, true) ==
          std::vector<std::string>{"order-one", "order-one-left", "mid-point"});
}

} // namespace cursor_tests
