// SPDX-License-Identifier: BSL-1.0
// 4096 members of an ensemble, each 1000 steps: as lanes on one processor and on two, one after the other as formulas, and by the best loop
// by hand, compiled with this program, which makes one after the other.
#include <atomic>

#include "engine/ensemble/ensemble.hpp"
#include "engine/machine_code/machine_code.hpp"
#include "engine/motions.hpp"
#include "small_by_hand.hpp"
#include "timing.hpp"

namespace bench {
namespace {

constexpr long members = 4096, steps = 1000;

template <class P>
class starts {
public:
    starts() {
        for (long k = 0; k < members; ++k) {
            double const x = static_cast<double>(k) / members;
            q_.push_back(P::q0);
            p_.push_back(P::p0);
            for (std::size_t j = 0; j < P::d; ++j) {
                q_.back()[j] *= 1 + x / 4;
                p_.back()[j] *= 1 - x / 8;
            }
        }
    }
    template <class Loop>
    double by_hand(Loop const& loop) const {
        double sum = 0;
        for (std::size_t k = 0; k < members; ++k) sum += loop(steps, q_[k], p_[k]);
        return sum;
    }
    [[nodiscard]] std::vector<engine::member> all() const {
        std::vector<engine::member> from;
        using row = Eigen::Map<Eigen::VectorXd const>;
        for (std::size_t k = 0; k < members; ++k)
            from.push_back({{row(q_[k].data(), P::d), engine::second_datum::velocity, row(p_[k].data(), P::d)}, {}});
        return from;
    }

private:
    std::vector<vector<P>> q_, p_;
};

template <class P, class Loop>
void race_ensemble(std::string const& name, std::string const& L, std::string const& method, Loop const& loop) {
    auto const words = std::make_shared<hilger::text::vocabulary>(std::vector<hilger::text::coordinate>{{"q", "v", P::d}});
    engine::problem const what{hilger::text::lagrangian_in(L, words), {}, {}, "direct"};
    engine::points<double> const T{0, P::h, steps, {}};
    engine::set_machine_code(engine::machine_code::at_once);
    auto const make = [&](engine::problem const& one) {
        auto made = engine::embedded_in_one_step(one, method, T);
        return engine::walker_of(made ? std::move(made) : engine::composed(one, method, T));
    };
    auto const together = engine::make_cast(what, method, T, true, make), alone = engine::make_cast(what, method, T, false, make);
    starts<P> const members_by_hand;
    auto const from = members_by_hand.all();
    auto const walked = [&](engine::cast const& all, int threads) {
        return [&, threads](long) {
            std::atomic<bool> const stop = false;
            std::atomic<hilger::index_type> done = 0;
            auto const made = engine::walk_all(all, from, steps, threads, stop, done);
            double sum = 0;
            for (std::size_t k = P::d; k < made.q.size(); k += 2 * P::d) sum += made.q[k];
            return sum;
        };
    };
    race(name + ", " + method + (together.together ? ", " + std::to_string(together.together->width()) + " lanes" : ", no lanes here"),
         members * steps, 5,
         {{"hand: one member after the other", [&](long) { return members_by_hand.by_hand(loop); }, true},
          {"hilger: in lanes, one thread", walked(together, 1)},
          {"hilger: in lanes, two threads", walked(together, 2)},
          {"hilger: one after the other, one thread", walked(alone, 1)}});
}

template <class P>
void race_methods(std::string const& name, std::string const& L) {
    race_ensemble<P>(name, L, "mid-point", midpoint_by_hand<P, 7>);
    race_ensemble<P>(name, L, "order-one", order_one_by_hand<P>);
    race_ensemble<P>(name, L, "verlet", verlet_by_hand<P>);
}

} // namespace

void ensembles() {
    std::cout
        << "Nanoseconds a step of a member, ratio to the loop by hand, and sums that need not agree: of all positions or of the last\n\n";
    race_methods<pendulum>("Pendulum", "v[0]^2/2 - (1 - cos(q[0]))");
    race_methods<henon_heiles>("Henon-Heiles", "dot(v, v)/2 - dot(q, q)/2 - q[0]^2*q[1] + q[1]^3/3");
    race_methods<kepler>("Kepler", "dot(v, v)/2 + 1/norm(q)");
}

} // namespace bench
