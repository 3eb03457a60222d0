// SPDX-License-Identifier: BSL-1.0
// The step of an embedding with one node for L = v.Mv / 2 - U(q) of any size (hilger/models/mechanical.hpp): with the velocity at the
// node as the unknown, M v = p - a_0 h U'(q + a_1 h v). First by iteration with M alone, which costs one gradient a round and gains a
// factor h^2 |M^-1 U''| / 4; where that is too little, by Newton, solving with M + a_0 a_1 h^2 U'' in the pattern that U has.
#pragma once

#include "hilger/linear/symmetric_matrix.hpp"
#include "hilger/newton/newton.hpp"
#include "hilger/newton/past_steps.hpp"
#include "hilger/newton/stop.hpp"
#include "hilger/step/force.hpp"
#include "hilger/step/mass_solver.hpp"
#include "hilger/step/state.hpp"
#include "hilger/step/summation.hpp"
#include "hilger/step/tableau.hpp"

namespace hilger::detail {

/// What one trajectory remembers from step to step.
template <class L, embedding_facts Facts, bool Compensated, class S, class V, class Extra = no_step_force>
class structured {
    using s = shape<V>;
    static constexpr bool resisted = has_step_force<Extra>;
    /// The mass, and to its diagonal what a force that grows with the step adds to it.
    static decltype(auto) inertia(L const& l, tableau<S> const& t, S const& h, Extra const& extra) {
        if constexpr (resisted) {
            V const more = extra.slope * S(h / S(2) * t.w(0));
            if constexpr (L::is_matrix) {
                block_of<V> m = l.mass().template cast<S>();
                if (m.rows() == more.size() and m.cols() == more.size()) m.diagonal() += more;
                return m;
            } else if constexpr (requires { l.mass().size(); })
                return l.mass().size() == more.size() ? V(l.mass().template cast<S>() + more) : V(l.mass().template cast<S>());
            else
                return V(more.array() + S(l.mass()));
        } else
            return l.mass();
    }
    using Mass = std::remove_cvref_t<decltype(inertia(std::declval<L const&>(), std::declval<tableau<S> const&>(), std::declval<S const&>(),
                                                      std::declval<Extra const&>()))>;
    static constexpr int history = Facts.at_start or Facts.at_end ? 1 : 8;

public:
    structured(tableau<S> const& t, S const& h, L const& l, V const& like, Extra extra = {})
        : extra_(std::move(extra)), mass_(inertia(l, t, h, extra_), like.size()), v_(like), r_(like), g_(like), A_(like), at_(like),
          next_(like), room_(like.size() + 1), past_(like), sum_q_(s::dimension(like)), sum_p_(s::dimension(like)) {
        l.potential().check(like.size());
        prepare(t, h);
    }
    void prepare(tableau<S> const& t, S const& h) {
        h_ = h;
        w_ = t.w(0);
        c_ = w_ * t.a(0, 1);
        f_ = w_ * t.a(0, 0);
        add_up_to(w_, c_, f_);
        if (known_ > 1) known_ = 0;
    }
    [[nodiscard]] S const& h() const { return h_; }
    [[nodiscard]] Extra& extra() { return extra_; }

    /// Everything that later steps depend on and h does not determine, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        int stiff = stiff_ ? 1 : 0;
        each("known", known_);
        each("stiff", stiff);
        stiff_ = stiff != 0;
        past_.visit("velocity", each);
        sum_q_.visit(each);
        sum_p_.visit(each);
    }

    void advance(L const& l, state<S, V>& x) {
        auto const& U = l.potential();
        if constexpr (resisted) start_ = x.p + S(h_ / S(2)) * extra_.constant;
        if constexpr (Facts.at_start) {
            force(U, x.q);
            mass_.solve(start(x) - w_ * g_, v_);
        } else if constexpr (Facts.at_end) {
            mass_.solve(start(x), v_);
            A_ = x.q + c_ * v_;
            force(U, A_);
        } else {
            first_guess(x);
            bool const done = not stiff_ and functional(U, x);
            if (not done) {
                if (not stiff_) first_guess(x);
                newton(l, x);
            }
        }
        // A finite v and g may still lead beyond the largest number; where v comes from the new momentum it shows that one.
        S sum = (x.q + w_ * v_).sum();
        if constexpr (resisted) r_ = S(w_ * h_) * extra_.slope.cwiseProduct(v_) - h_ * extra_.constant; // taken beside w U'
        if constexpr (resisted)
            sum += (x.p - w_ * g_ - r_).sum();
        else if constexpr (not Facts.at_start)
            sum += (x.p - w_ * g_).sum();
        if (not is_finite(sum)) [[unlikely]]
            refuse_overflow(x);
        if constexpr (Compensated)
            for (int k = 0; k < s::dimension(x.q); ++k) {
                sum_q_.add(x.q(k), S(w_ * v_(k)), k);
                sum_p_.add(x.p(k), gained(k), k);
            }
        else {
            x.q += w_ * v_;
            x.p -= w_ * g_;
            if constexpr (resisted) x.p -= r_;
        }
        x.t = x.t + h_;
        if constexpr (history > 1) {
            past_.keep(v_);
            if (known_ < history) ++known_;
        }
    }

private:
    static constexpr char const* name = "the step p = -d_1 L_h(q, y)";
    /// @throws error::not_finite, unless it was the sum alone that overflowed
    [[gnu::noinline, gnu::cold]] void refuse_overflow(state<S, V> const& x) {
        next_ = resisted ? r_ : V(zero_like(r_));
        r_ = next_ - next_;
        r_ += (x.q + w_ * v_) - (x.q + w_ * v_);
        r_ += (x.p - w_ * g_) - (x.p - w_ * g_);
        if (not all_finite(r_)) throw_newton_failure(name, newton_outcome::not_finite, v_, r_);
    }
    /// The momentum at the start, with what of the extra force does not depend on v.
    [[nodiscard]] V const& start(state<S, V> const& x) const {
        if constexpr (resisted)
            return start_;
        else
            return x.p;
    }
    /// The change of the momentum, after which r_ is what the extra force has taken.
    [[nodiscard]] S gained(index_type k) const {
        if constexpr (resisted)
            return S(-(w_ * g_(k)) - r_(k));
        else
            return S(-(w_ * g_(k)));
    }
    template <class U>
    void force(U const& potential, V const& q) {
        branch_watch const watch;
        potential.gradient(q, g_, room_);
        path_before_ = path_;
        path_ = watch.saw_any() ? watch.path() : branch_path{};
    }
    [[nodiscard]] bool has_branches() const { return not(path_ == branch_path{}); }
    /// Whether the force was the same formula the last two times: then what an iteration has concluded from the one holds of the other.
    [[nodiscard]] bool on_one_branch() const { return path_ == path_before_; }
    /// The same of the next force, at the velocity that is to be returned; a force without branches is none.
    template <class U>
    bool stays_on_its_branch(U const& potential, state<S, V> const& x) {
        if (not has_branches()) return true;
        A_ = x.q + c_ * v_;
        force(potential, A_);
        return on_one_branch();
    }
    void first_guess(state<S, V> const& x) {
        if (known_ > 0)
            past_.guess(v_, known_);
        else
            mass_.solve(start(x), v_);
    }
    /// False where it converges too slowly to be worth it.
    template <class U>
    bool functional(U const& potential, state<S, V> const& x) {
        S previous(-1);
        for (int round = 0; round < most_iterations<S>; ++round) {
            A_ = x.q + c_ * v_;
            force(potential, A_);
            mass_.solve(start(x) - f_ * g_, next_);
            S const size = largest_difference(), reach = largest_of(next_);
            hand_over(next_, v_);
            // What is left is the rate times this correction, and the rate is the ratio of two corrections.
            S const floor = epsilon<S>() * reach;
            bool const converged = size <= floor * S(8) or (round > 8 and size <= floor * S(64)) or
                                   (previous > S(0) and size * (size / previous) <= floor * small());
            if (converged and stays_on_its_branch(potential, x)) return true;
            if (previous > S(0)) {
                if (not(S(4) * size < previous) and S(1024) * floor < size) { // and not among rounding errors, which do not shrink
                    stiff_ = true;
                    return false;
                }
            }
            previous = size;
        }
        return false;
    }
    void newton(L const& l, state<S, V> const& x) {
        auto const& U = l.potential();
        if (not prepared_) {
            kernel_.prepare(U.pattern(x.q.size()), x.q.size(), [&](auto const& put) {
                U.hessian(x.q, put);
                mass_.put(put);
            });
            prepared_ = true;
        }
        auto const put = [&](index_type j, index_type k, S const& y) { kernel_.add(j, k, y); };
        S const scale = f_ * c_;
        S size(0);
        constexpr bool follows = not std::numeric_limits<S>::is_exact;
        for (int round = 0; round < most_iterations<S>; ++round) {
            A_ = x.q + c_ * v_;
            force(U, A_);
            kernel_.set_zero();
            mass_.put(put);
            U.hessian(A_, [&](index_type j, index_type k, S const& y) { kernel_.add(j, k, S(scale * y)); });
            // M v rounds; r = p - f U' - M v with the same mass that the kernel has
            residual(l, x, f_);
            next_ = r_;
            bool const regular = kernel_.solve(next_), is_number = is_finite(S(next_.sum()));
            if ((follows or has_branches()) and not(regular and is_number)) break;
            if (not regular) throw_newton_failure(name, newton_outcome::singular, v_, r_);
            v_ += next_;
            size = largest_of(next_);
            if (not is_number) throw_newton_failure(name, newton_outcome::not_finite, v_, next_);
            if (size <= square_root_of_epsilon<S>() * S(Compensated ? 1 : 64) / S(1024) * largest_of(v_) or
                (round > 1 and largest_of(r_) <= S(8) * epsilon<S>() * (largest_of(start(x)) + magnitude(f_) * largest_of(g_)))) {
                A_ = x.q + c_ * v_;
                force(U, A_);
                if (not on_one_branch()) continue;
                if (not follows or has_branches() or is_near_the_last(round)) return;
                break;
            }
        }
        if (not follows and not has_branches()) throw_newton_failure(name, newton_outcome::lost, v_, r_);
        first_guess(x);
        search(l, x);
    }
    /// For a U with branches, where full steps of Newton's method go round between them, and where an extrapolated guess leads nowhere.
    [[gnu::noinline, gnu::cold]] void search(L const& l, state<S, V> const& x) {
        auto const& U = l.potential();
        S share(1);
        S bends(0);
        auto const evaluate_at = [&](V const& y, V& r) {
            S const c = share * c_, f = share * f_;
            v_ = y;
            A_ = x.q + c * v_;
            force(U, A_);
            residual(l, x, f);
            r = r_;
            return S(largest_of(x.p) * S(2) + magnitude(f) * (largest_of(g_) + bends * (largest_of(x.q) + largest_of(A_))));
        };
        auto const linearize = [&] {
            bends = S(0);
            U.hessian(A_, [&](index_type, index_type, S const& b) { bends = std::max(bends, S(magnitude(b))); });
            at_ = A_;
            V none = zero_like(v_);
            return solved(l, share, none);
        };
        auto const correct = [&](V const& r, V& d) {
            d = r;
            (void)solved(l, share, d);
        };
        V const last = known_ > 0 ? past_[0] : v_;
        V y = v_, rest = v_;
        auto const set_share = [&](S const& of_step) { share = of_step; };
        newton_outcome const how = root_of_step<V>(has_branches(), {evaluate_at, linearize, correct}, y, last, rest, set_share);
        if (how != newton_outcome::found) throw_newton_failure(name, how, y, rest);
    }
    /// d = K^-1 d with the derivative at the position at_, whose factors are used up.
    bool solved(L const& l, S const& share, V& d) {
        kernel_.set_zero();
        auto const put = [&](index_type j, index_type k, S const& y) { kernel_.add(j, k, y); };
        mass_.put(put);
        S const scale = share * f_ * (share * c_);
        l.potential().hessian(at_, [&](index_type j, index_type k, S const& b) { kernel_.add(j, k, S(scale * b)); });
        return kernel_.solve(d);
    }
    [[nodiscard]] bool is_near_the_last(int round) const {
        if (known_ < 2) return is_near(round, known_, S(0), S(0), S(0));
        return is_near(round, known_, largest_of(v_ - past_[0]), largest_of(past_[0] - past_[1]), largest_of(past_[1] - past_[2]));
    }
    void residual(L const& l, state<S, V> const& x, S const& f) {
        if constexpr (L::is_matrix)
            r_ = start(x) - f * g_ - l.mass().template cast<S>() * v_;
        else if constexpr (requires { l.mass().size(); })
            r_ = start(x) - f * g_ - l.mass().template cast<S>().cwiseProduct(v_);
        else
            r_ = start(x) - f * g_ - S(l.mass()) * v_;
        if constexpr (resisted) r_ -= S(w_ * h_ / S(2)) * extra_.slope.cwiseProduct(v_);
    }
    /// Gives `to` the numbers of `from`, which are not needed there any more: the cheapest way.
    static void hand_over(V& from, V& to) {
        if constexpr (s::size == Eigen::Dynamic)
            to.swap(from);
        else
            to = from;
    }
    template <class X>
    static S largest_of(X const& x) {
        return x.cwiseAbs().maxCoeff();
    }
    S largest_difference() const { return (next_ - v_).cwiseAbs().maxCoeff(); }
    static S small() { return Compensated ? S(1) / S(256) : S(1) / S(2); }

    [[no_unique_address]] Extra extra_;
    [[no_unique_address]] std::conditional_t<resisted, V, no_step_force> start_;
    S h_, w_, c_, f_;
    mass_solver<Mass, V> mass_;
    symmetric_matrix<S> kernel_;
    bool prepared_ = false, stiff_ = false;
    V v_, r_, g_, A_, at_, next_;
    Eigen::Matrix<S, Eigen::Dynamic, 1> room_;
    branch_path path_, path_before_; ///< of the last force and of the one before
    past_steps<V, S, history> past_;
    int known_ = 0;
    [[no_unique_address]] summation<Compensated, S, s::size> sum_q_;
    [[no_unique_address]] summation<Compensated, S, s::size> sum_p_;
};

} // namespace hilger::detail
