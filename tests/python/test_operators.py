# SPDX-License-Identifier: BSL-1.0
"""Operators composed in Python, and embeddings made of them: the same equations, steps and bits as those that have names."""

import functools
import pickle
import unittest
from fractions import Fraction

import numpy as np

import hilger as h

pendulum = h.Lagrangian("v^2/2 - (1 - cos(q))")
springs = h.Lagrangian("(u^2 + v^2/3)/2 - (x^2 + x*y + y^2)/4", "x y", "u v")
T = h.TimeScale(["0", "1/3", "1", "7/5", "2"])


class Operators(unittest.TestCase):
    def test_algebra(self):
        self.assertEqual(h.rho * h.Delta_plus, h.Delta_minus)
        self.assertEqual(h.Delta_plus[h.sigma], h.Delta_plus * h.sigma)
        self.assertNotEqual(h.Delta_plus * h.sigma, h.sigma * h.Delta_plus)
        self.assertTrue((h.Delta_plus * h.sigma).equals(h.sigma * h.Delta_plus, uniform=True))
        self.assertEqual((1 + h.sigma) / 2, Fraction(1, 2) * (h.identity + h.sigma))
        self.assertEqual(2 - h.rho - 1, h.identity - h.rho)
        self.assertEqual(h.sigma * 0.1, h.sigma / 10)
        self.assertNotEqual(h.sigma, 1)
        A = (h.Delta_plus + h.sigma) / 2
        for n in range(6):
            self.assertEqual(A**n, functools.reduce(lambda B, _: A * B, range(n), h.identity))
        for nonsense in (lambda: h.sigma + "x", lambda: 2 / h.sigma, lambda: h.sigma * h.variables("q"), lambda: h.sigma / h.rho, lambda: h.sigma[2]):
            with self.assertRaises((TypeError, h.Error)):
                nonsense()

    def test_scales_in_texts(self):
        points, values = h.apply(h.Delta_plus, [1, 2, 4, 8], h.uniform("1", "2", 3))
        self.assertEqual((list(points), list(values)), ([1, 3, 5], [Fraction(1, 2), 1, 2]))
        points, values = h.apply(h.sigma, lambda t: t * t, h.uniform("0.5", "1/2", 2))
        self.assertEqual((list(points), list(values)), ([Fraction(1, 2), 1], [1, Fraction(9, 4)]))
        points, _ = h.apply(h.sigma, lambda t: t, h.TimeScale(["0.5", "1", "3/2"]))
        self.assertEqual(list(points), [Fraction(1, 2), 1])
        points, _ = h.apply(h.sigma, lambda t: t, h.uniform(0, "1", 2))
        self.assertEqual(list(points), [0, 1])

    def test_adjoints(self):
        self.assertEqual(h.adjoint(h.sigma), h.rho)
        self.assertEqual(h.adjoint(h.Delta_plus), -h.Delta_minus)
        A = h.Delta_plus * h.sigma - h.rho / 3
        # sum of nu Af g = sum of nu f A*g, of the sums of its first term, for what vanishes at the ends
        T = h.TimeScale([Fraction(k * k + k, 3) for k in range(9)])
        f, g = ([0, 0, 0, 2, -5, 7, 0, 0, 0], [0, 0, 0, 1, 4, -3, 0, 0, 0])
        mu = [b - a for a, b in zip(T.points, T.points[1:])] + [0]
        nu = [0] + mu[:-1]

        def paired(weights, t, x, y):
            at = {s: (w, z) for s, w, z in zip(T.points, weights, y)}
            return sum(at[s][0] * z * at[s][1] for s, z in zip(t, x))

        left = paired(mu, *h.apply(A, f, T), g)
        right = paired(nu, *h.apply(h.adjoint(A), g, T), f)
        self.assertEqual(left, right)
        self.assertNotEqual(left, 0)

    def test_application(self):
        t, y = h.apply(h.Delta_plus, lambda t: t * t, T)
        self.assertEqual(list(t), [0, Fraction(1, 3), 1, Fraction(7, 5)])
        self.assertEqual(list(y), [Fraction(1, 3), Fraction(4, 3), Fraction(12, 5), Fraction(17, 5)])
        t, y = h.apply((h.Delta_plus + h.Delta_minus) / 2, np.sin, h.uniform(0, 0.125, 16))
        self.assertEqual(t.tolist(), [k / 8 for k in range(1, 16)])
        self.assertLess(np.abs(y - np.sin(0.125) / 0.125 * np.cos(t)).max(), 16 * np.finfo(float).eps)
        import mpmath

        t, y = h.apply(h.Delta_plus, [mpmath.mpf(1), mpmath.mpf(4)], h.uniform(mpmath.mpf(0), mpmath.mpf(3), 1))
        self.assertEqual(list(y), [1])
        with self.assertRaisesRegex(h.Mismatch, "a value at each of its 5 points, and here are 2"):
            h.apply(h.sigma, [1, 2], T)

    def test_writing(self):
        A = (h.identity + h.sigma) / 2
        self.assertEqual(repr(A), "1/2 f + 1/2 σ[f]")
        self.assertEqual(A._repr_latex_(), r"$\tfrac{1}{2}\,f + \tfrac{1}{2}\,\sigma\left[f\right]$")
        self.assertEqual(A.text, "(q + sigma[q])/2")
        self.assertEqual(pickle.loads(pickle.dumps(A)), A)


class Embeddings(unittest.TestCase):
    pairs = [
        (h.embedding(h.identity, h.Delta_plus), h.order_one),
        (h.embedding(h.identity, h.Delta_minus, integral="nabla"), h.order_one_left),
        (h.embedding((h.identity + h.sigma) / 2, h.Delta_plus), h.midpoint),
        (h.embedding("2/3*q + sigma[q]/3", "Delta_plus[q]"), h.theta(Fraction(1, 3))),
    ]

    def test_exact_steps(self):
        for scale in (T, h.uniform(0, Fraction(1, 4), 5)):
            for mine, named in self.pairs[:3]:
                x, y = (h.solve(h.variation(springs, scale, m), q0=[1, 2], v0=[0, 1]) for m in (mine, named))
                self.assertTrue((x.q == y.q).all() and (x.p == y.p).all())
                self.assertEqual(x.residual(), 0)
                z = h.solve(h.variation(springs, scale, mine), q0=list(x.q[0]), qN=list(x.q[-1]))
                self.assertTrue((z.q == x.q).all())

    def test_double(self):
        for L, q0, v0 in ((pendulum, 1.0, 0.0), (springs, [1.0, 2.0], [0.0, 1.0])):
            for mine, named in self.pairs:
                x, y = (h.solve(h.variation(L, h.uniform(0, 0.125, 200), m), q0=q0, v0=v0) for m in (mine, named))
                self.assertLess(np.abs(x.q - y.q).max(), 200 * 200 * np.finfo(float).eps)
                self.assertLess(x.residual(), 64)

    def test_factors_that_are_floats(self):
        T = h.uniform(0, 0.1, 20)
        for c in (0.7, 1 / 7, 2**0.5 - 1, 0.1 * 3, 1 / 3):
            for position in ((1 - c) * h.identity + c * h.sigma, h.identity + c * (h.sigma - h.identity)):
                mine = h.solve(h.variation(pendulum, T, h.embedding(position, h.Delta_plus)), q0=1.0, v0=0.0)
                its = h.solve(h.variation(pendulum, T, h.theta(c)), q0=1.0, v0=0.0)
                np.testing.assert_allclose(mine.q, its.q, rtol=0, atol=1e-14)
        rounded = h.embedding(0.7 * h.identity + (0.1 * 3) * h.sigma, h.Delta_plus)
        with self.assertRaisesRegex(h.InvalidParameter, "makes 1 of the constant 1"):  # exactly it does not
            h.variation(pendulum, h.uniform(Fraction(0), Fraction(1, 10), 3), rounded)

    def test_members_and_c(self):
        mine, named = self.pairs[3]
        T = h.uniform(0, 0.125, 40)
        many = h.solve_many(h.variation(pendulum, T, mine), q0=np.linspace(0.1, 2, 9), v0=0.0)
        for k, q in enumerate(np.linspace(0.1, 2, 9)):
            one = h.solve(h.variation(pendulum, T, named), q0=q, v0=0.0)
            self.assertLess(abs(many.q[k][-1] - one.q[-1]), 40 * 40 * np.finfo(float).eps)
        self.assertIn("int third_step(double h", h.variation(pendulum, T, mine).c_code("third"))

    def test_parameters_forces_and_the_equation(self):
        L = h.Lagrangian("v^2/2 - q^2/2", lam="1/3")
        EL = h.variation(L, T, "integral(L((1 - lam)*q + lam*sigma[q], Delta_plus[q]))") + h.force("-v/7")
        x = h.solve(EL, q0=1, v0=0)
        self.assertEqual(x.residual(), 0)
        same = h.solve(h.variation(L, T, self.pairs[3][0]) + h.force("-v/7"), q0=1, v0=0)
        self.assertEqual(list(x.q), list(same.q))
        printed = repr(h.variation(L, h.uniform(0, 0.1, 9), self.pairs[2][0]))
        self.assertIn("1/2 ∂L/∂q(⋆) + 1/2 ρ[∂L/∂q(⋆)] − Δ₋[∂L/∂v(⋆)] = 0   on T±,   ⋆ = (1/2 q + 1/2 σ[q], Δ₊[q])", printed)

    def test_a_lambda_for_each_length_of_step(self):
        """q + Delta_plus[q]/20 is the mid-point where h = 1/10, and near the start where h is large: every engine knows."""
        own = h.embedding(h.identity + h.Delta_plus / 20, h.Delta_plus)
        equal, uneven = h.uniform(0, 0.1, 50), h.TimeScale([0, 0.1, 0.3, 0.35, 0.6, 1.0])

        def near(x, y):
            np.testing.assert_allclose(np.array(x.q, float), np.array(y.q, float), rtol=0, atol=1e-13)

        for d in range(1, 6):
            q, v = h.variables("q v", d)
            L = h.Lagrangian(v @ v / 2 + sum(h.cos(q[k]) for k in range(d)) - q[0] * q[d - 1] / 8, q, v)
            start = dict(q0=[0.5 + k / 4 for k in range(d)], v0=[0.25] * d)
            for compiled in (False, True):
                near(h.solve(h.variation(L, equal, own), **start, compiled=compiled), h.solve(h.variation(L, equal, h.midpoint), **start))
                x = h.solve(h.variation(L, uneven, own), **start, compiled=compiled)
                self.assertLess(x.residual(), 64)
        near(x, h.solve(h.variation(L, uneven, own), **start, compiled=False))
        for scale in (equal, uneven):
            EL, q0 = h.variation(pendulum, scale, own), np.array([0.5, 0.75, 1.0])
            for lanes in (True, False):
                many = h.solve_many(EL, q0=q0, v0=0.0, lanes=lanes)
                for k in range(3):
                    self.assertAlmostEqual(many.q[k][-1], h.solve(EL, q0=q0[k], v0=0.0).q[-1], delta=1e-13)
        half = h.Lagrangian("v^2/4 - (1 - cos(q))/2")
        EL = h.variation(half, equal, own)
        near(h.solve(EL + EL, q0=1, v0=0), h.solve(h.variation(pendulum, equal, h.midpoint), q0=1, v0=0))
        near(h.solve(h.variation(pendulum, equal, own), q0=1, qN=0.5), h.solve(h.variation(pendulum, equal, h.midpoint), q0=1, qN=0.5))
        exact, whole = h.Lagrangian("v^2/4 - q^2/4"), h.Lagrangian("v^2/2 - q^2/2")
        of = h.uniform(0, Fraction(1, 10), 4)
        once = h.solve(h.variation(whole, of, h.midpoint), q0=1, v0=0)
        EL = h.variation(exact, of, own)
        self.assertEqual(list(h.solve(EL + EL, q0=1, v0=0).q), list(once.q))
        self.assertEqual(list(h.solve(h.variation(whole, of, own), q0=1, v0=0).q), list(once.q))
        EL = h.variation(half, uneven, own)
        with self.assertRaisesRegex(h.InvalidParameter, "another mean of the ends for each length of the step"):
            h.solve(EL + EL, q0=1, v0=0)
        with self.assertRaisesRegex(h.InvalidParameter, "another mean of the ends for each length of the step"):
            h.variation(pendulum, equal, own).c_code("own")

    def test_what_operators_are_asked(self):
        self.assertEqual(h.embedding("sigma^2", "Delta_plus"), h.embedding(h.sigma * h.sigma, "Delta_plus"))
        self.assertIn("more than 10 000 characters", repr((h.sigma + h.identity) ** 22))
        self.assertIn("more than 10 000 characters", ((h.sigma + h.identity) ** 22)._repr_latex_())
        self.assertIn(r"\mathtt{sqrt(2)}", (h.sqrt(2) * h.sigma)._repr_latex_())
        self.assertFalse(h.sigma.equals(2))
        self.assertTrue(h.identity.equals(1))
        for wrong in (lambda: h.adjoint(2), lambda: h.adjoint(h.midpoint), lambda: h.sigma.equals("sigma")):
            with self.assertRaisesRegex(TypeError, "an operator, as h"):
                wrong()
        with self.assertRaises(h.Error):
            h.sqrt(-1) * h.sigma == h.sigma
        with self.assertRaisesRegex(h.Error, "there are q, identity, sigma, rho, Delta_plus, Delta_minus and numbers"):
            h.embedding("(1 - c)*q + c*sigma[q]", "Delta_plus")

    def test_what_is_none(self):
        def refused(says, method, error=h.InvalidParameter):
            with self.assertRaisesRegex(error, says):
                h.variation(pendulum, T, method)

        refused("reach further", h.embedding(h.identity, (h.Delta_plus + h.Delta_minus) / 2))
        refused("makes 1 of the constant 1", h.embedding(2 * h.identity, h.Delta_plus))
        refused("has the other one", h.embedding(h.identity, h.Delta_minus))
        refused("line 1, column 12: an operator is linear in q", "integral(L(q*q, Delta_plus[q]))", h.Unreadable)
        refused("there is no method 'midpiont'", "midpiont")
        with self.assertRaisesRegex(h.InvalidParameter, '"delta" or "nabla"'):
            h.embedding(h.identity, h.Delta_plus, integral="sum")
        with self.assertRaisesRegex(TypeError, "the position of an embedding is an operator"):
            h.embedding(1, h.Delta_plus)


if __name__ == "__main__":
    unittest.main()
