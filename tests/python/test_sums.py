# SPDX-License-Identifier: BSL-1.0
"""Equations of several Lagrangians, each read by a method of its own: the equation by hand in fractions, the residual, and what they print."""

import unittest
import warnings
from fractions import Fraction

import numpy as np

import hilger as h

epsilon = np.finfo(float).eps
fast = h.Lagrangian("v^2/2 - 8*q^2")
slow = h.Lagrangian("cos(q) - q^2/8")
half_slow = h.Lagrangian("(cos(q) - q^2/8)/2")


def implicit_explicit(T):
    """The fast part by the mid-point rule, the slow one by the trapezoid rule (Stern, Grinspun 2009)."""
    return h.variation(fast, T, h.midpoint) + h.variation(half_slow, T, h.order_one) + h.variation(half_slow, T, h.order_one_left)


class Sums(unittest.TestCase):
    def test_by_hand_in_fractions(self):
        m, k, c, g = (Fraction(*x) for x in ((3, 2), (1, 1), (2, 3), (1, 5)))
        points = [Fraction(0), Fraction(1, 3), Fraction(1), Fraction(7, 5), Fraction(2)]
        for T, at in ((h.TimeScale(points), points), (h.uniform(0, Fraction(1, 4), 6), [Fraction(i, 4) for i in range(7)])):
            for lam, method in ((Fraction(0), h.order_one), (Fraction(1), h.order_one_left), (Fraction(1, 4), h.theta(Fraction(1, 4)))):
                # L1 by the mid-point, L2 at (1 - lam) q_i + lam q_{i+1}, friction where L1 is read
                L1 = h.Lagrangian("m*v^2/2 - k*q^2/2 + q*v/3", m=m, k=k)
                L2 = h.Lagrangian("-c*q^2/2 + g*t*q", c=c, g=g)
                EL = h.variation(L1, T, h.midpoint) + h.variation(L2, T, method) + h.force("-v/7")
                x = h.solve(EL, q0=1, v0=Fraction(-1, 2))
                q = list(x.q)
                self.assertEqual(x.residual(), 0)
                before, after = [], []  # -d1 and d2 of both discrete Lagrangians, with the impulses of the force
                for s, t, a, b in zip(at, at[1:], q, q[1:]):
                    mu, mean, v = t - s, (a + b) / 2, (b - a) / (t - s)
                    by_q, by_v = -k * mean + v / 3 - v / 7, m * v + mean / 3
                    there = (1 - lam) * a + lam * b
                    own = mu * (-c * there + g * (s + lam * mu))
                    before.append(by_v - mu * by_q / 2 - (1 - lam) * own)
                    after.append(by_v + mu * by_q / 2 + lam * own)
                self.assertEqual(before[1:], after[:-1])
                self.assertEqual(list(x.p), [before[0], *after])
                self.assertEqual(before[0], m * Fraction(-1, 2) + Fraction(1, 3))
                again = h.solve(EL, q0=1, q1=q[1])
                self.assertEqual((list(again.q), list(again.p)), (q, list(x.p)))

    def test_the_equation_is_the_judge(self):
        plane = [h.Lagrangian(L, "q[2]", "v[2]") for L in ("dot(v, v)/2 - 8*dot(q, q)", "q[0]*v[1]/2 - q[0]^2*q[1]^2", "sin(t)*q[0]")]
        uneven = h.TimeScale(np.cumsum(0.05 + 0.02 * np.sin(np.arange(60.0))))
        for T in (h.uniform(0, 0.05, 100), uneven):
            of_vectors = sum((h.variation(L, T, by) for L, by in zip(plane[1:], (h.order_one, h.theta(0.3)))), start=h.variation(plane[0], T, h.midpoint))
            of_own = h.variation(fast, T, h.embedding((h.identity + h.sigma) / 2, h.Delta_plus)) + h.variation(slow, T, h.embedding("identity", "Delta_minus", "nabla"))
            for EL, q0, v0 in ((implicit_explicit(T), 0.5, -1.0), (of_own, 0.5, -1.0), (implicit_explicit(T) + h.force("-v/5 + cos(t)"), 0.5, -1.0), (of_vectors, [0.5, 0.25], [0.0, 1.0])):
                x = h.solve(EL, q0=q0, v0=v0)
                bound = 64 * epsilon * (4 / 0.03 + 32)
                self.assertLess(x.residual(), 64)
                x.q[7] += 1e-6
                self.assertGreater(x.residual(), 1e6)
                x.q[7] = np.nan
                with self.assertRaises(h.NotFinite):
                    x.residual()
                x.q[7] = h.solve(EL, q0=q0, v0=v0).q[7]
                again = h.solve(EL, q0=q0, q1=x.q[1])
                self.assertLess(np.abs(again.q - x.q).max(), 1e-12)

    def test_between_two_ends(self):
        uneven = h.TimeScale(np.cumsum(0.05 + 0.02 * np.sin(np.arange(30.0))))
        for T in (h.uniform(0, 0.05, 30), uneven):
            for EL, q0, v0 in (
                (implicit_explicit(T), 0.5, -1.0),
                (implicit_explicit(T) + h.force("-v/5 + cos(t)"), 0.5, -1.0),
                (h.variation(h.Lagrangian("dot(v, v)/2 - dot(q, q)", "q[2]", "v[2]"), T) + h.variation(h.Lagrangian("q[0]^2*q[1] + sin(t)*q[0]", "q[2]", "v[2]"), T, h.theta(0.3)), [0.5, 0.25], [0.0, 1.0]),
            ):
                walk = h.solve(EL, q0=q0, v0=v0)
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore", h.DoubtfulSolution)  # the steps are few, and some are coarse
                    x = h.solve(EL, q0=q0, qN=walk.q[-1])
                    guessed = h.solve(EL, q0=q0, qN=walk.q[-1], guess=walk.q + 0.125)
                self.assertLess(np.abs(x.q - walk.q).max(), 1e-11)
                self.assertLess(x.residual(), 64)
                self.assertLess(np.abs(guessed.q - walk.q).max(), 1e-11)
        linear = h.Lagrangian("-q^2/3 + t*q")
        for T in (h.uniform(0, Fraction(1, 4), 6), h.TimeScale([Fraction(0), Fraction(1, 3), Fraction(1), Fraction(7, 5)])):
            EL = h.variation(h.Lagrangian("v^2/2 - q^2"), T) + h.variation(linear, T, h.order_one) + h.variation(linear, T, h.theta(Fraction(1, 4)))
            walk = h.solve(EL, q0=1, v0=Fraction(-1, 2))
            x = h.solve(EL, q0=1, qN=walk.q[-1])
            self.assertEqual((list(x.q), x.residual()), (list(walk.q), 0))

    def test_one_method_for_all_is_one_lagrangian(self):
        T = h.uniform(0, 0.05, 200)
        whole = h.Lagrangian("v^2/2 - 8*q^2 + cos(q) - q^2/8")
        for method in (h.midpoint, h.order_one, h.order_one_left, h.theta(0.3)):
            one = h.solve(h.variation(whole, T, method), q0=0.5, v0=-1.0)
            two = h.solve(h.variation(fast, T, method) + h.variation(slow, T, method), q0=0.5, v0=-1.0)
            self.assertLess(max(np.abs(one.q - two.q).max(), np.abs(one.p - two.p).max()), 200 * 64 * epsilon)
            self.assertLess(np.abs(one.energy() - two.energy()).max(), 200 * 64 * epsilon * 8)

    def test_order_dense_output_and_events(self):
        ends = []
        for n in (100, 200, 400):
            x = h.solve(implicit_explicit(h.uniform(0, 2 / n, n)), q0=0.5, v0=-1.0)
            ends.append(x.q[-1])
        self.assertAlmostEqual(np.log2((ends[0] - ends[1]) / (ends[1] - ends[2])), 2, delta=0.02)
        exact = h.solve(h.Lagrangian("v^2/2 - 8*q^2 + cos(q) - q^2/8"), (0, 2), q0=0.5, v0=-1.0, accuracy=1e-10).q[-1]
        self.assertLess(abs(ends[2] - exact), 1e-4)
        self.assertLess(abs(x(0.5025) - (x.q[100] + x.q[101]) / 2), 1e-3)
        zeros = x.events(lambda t, q, p: q)
        self.assertLess(np.abs(zeros.q).max(), 8 * epsilon)
        self.assertEqual(len(zeros.t), int(np.sum(np.diff(np.sign(x.q)) != 0)))
        self.assertLess(np.abs(x.energy() - x.energy()[0]).max(), 0.01)

    def test_50_digits_and_ensembles(self):
        import mpmath

        with mpmath.workdps(50):
            T = h.uniform(mpmath.mpf(0), mpmath.mpf("0.05"), 20)
            x = h.solve(implicit_explicit(T), q0=mpmath.mpf("0.5"), v0=mpmath.mpf(-1))
            self.assertLess(x.residual(), 64)
            y = h.solve(implicit_explicit(h.uniform(0, 0.05, 20)), q0=0.5, v0=-1.0)
            self.assertLess(max(abs(a - b) for a, b in zip(x.q, y.q)), 1e-13)
        many = h.solve_many(implicit_explicit(h.uniform(0, 0.05, 20)), q0=[0.5, 0.25], v0=-1.0, every=1)
        self.assertEqual((many.failed, many.q[0].tolist()), ({}, y.q.tolist()))

    def test_printing(self):
        T = h.uniform(0, 0.1, 4)
        EL = sum([h.variation(fast, T, h.midpoint), h.variation(slow, T, h.order_one), h.force("-v")])
        self.assertEqual(
            repr(EL),
            f"L₁ = {fast._written(False)},   L₂ = {slow._written(False)}\n"
            "1/2 ∂L₁/∂q(⋆₁) + 1/2 ρ[∂L₁/∂q(⋆₁)] − Δ₋[∂L₁/∂v(⋆₁)] + ∂L₂/∂q(⋆₂) − Δ₋[∂L₂/∂v(⋆₂)] = 0   on T±,   ⋆₁ = (1/2 q + 1/2 σ[q], Δ₊[q]),   ⋆₂ = (q, Δ₊[q])\n"
            "beside ∂L/∂q: -v\n",
        )
        self.assertIn("\\frac{\\partial L_{2}}{\\partial q}", EL._repr_latex_())
        self.assertIn("L_{1} = ", EL._repr_latex_())
        self.assertIn("<mid-point + order-one, 5 points", repr(h.solve(EL, q0=1.0, v0=0.0)))

    def test_refused(self):
        T = h.uniform(0, 0.1, 4)
        EL, other = h.variation(fast, T), h.variation(slow, T, h.order_one)
        two = EL + other

        def says(kind, sentence, work):
            with self.assertRaises(kind) as refused:
                work()
            self.assertIn(sentence, str(refused.exception))

        says(TypeError, "unsupported operand", lambda: 1 + EL)
        says(h.InvalidParameter, "what adds up is read in one step, by order-one", lambda: EL + h.variation(slow, T, h.verlet))
        says(h.InvalidParameter, "and not by 'gauss-4'", lambda: h.variation(slow, T, h.gauss(4)) + EL)
        says(h.Mismatch, "equations add up on one scale", lambda: EL + h.variation(slow, h.uniform(0, 0.1, 5)))
        says(h.Mismatch, "equations add up of the same coordinates", lambda: EL + h.variation(h.Lagrangian("u^2", "x", "u"), T))
        says(h.InvalidParameter, "fractional damping is beside one Lagrangian", lambda: two + h.damping(0.1, 0.5))
        says(h.InvalidParameter, "equations add up without damping", lambda: EL + h.damping(0.1, 0.5) + other)
        says(h.InvalidParameter, "forces are beside the first one", lambda: EL + (other + h.force("-v")))
        says(h.InvalidParameter, "C code is of one Lagrangian", lambda: two.c_code("two"))
        says(h.Mismatch, "q0 is one number", lambda: h.solve(two, q0=[1, 2], qN=0))
        says(h.InvalidParameter, "members differ in parameters of one Lagrangian", lambda: h.solve_many(two, q0=1, v0=0, parameters={"k": [1.0]}))


if __name__ == "__main__":
    unittest.main()
