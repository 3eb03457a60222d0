# SPDX-License-Identifier: BSL-1.0
"""Scales that follow the motion: a formula g of dt = g(q) dtau, and solutions at their own times."""

import copy
import pickle
import unittest
from fractions import Fraction

import numpy as np

import hilger as h

x, y, v, w = h.variables("x y v w")
kepler = h.Lagrangian((v**2 + w**2) / 2 + 1 / h.hypot(x, y), (x, y), (v, w))
e = 0.9
start = {"q0": [1 - e, 0], "v0": [0, ((1 + e) / (1 - e)) ** 0.5]}  # E = -1/2, and a revolution takes 2 pi
T = h.uniform(0, 2 * np.pi / 64, 2 * 64)


def eccentric(E):
    return np.array([np.cos(E) - e, np.sqrt(1 - e * e) * np.sin(E)]).T


class TransformedTime(unittest.TestCase):
    def test_the_steps_are_equal_in_the_eccentric_anomaly(self):
        E = 2 * np.pi / 64 * np.arange(2 * 64 + 1)
        for g in (h.hypot(x, y), "sqrt(x^2 + y^2)", h.sundman(1), h.sundman(1, h.hypot(x, y)), h.inverse_potential(kepler)):
            EL = h.variation(h.transform_time(kepler, g), T, h.gauss(4))
            at = {"q0": start["q0"], "p0": start["v0"]} if isinstance(g, str) else start
            s = h.solve(EL, **at)
            self.assertLess(np.abs(s.t - (E - e * np.sin(E))).max(), 1e-8)
            self.assertLess(np.abs(s.q - eccentric(E)).max(), 1e-8)
            self.assertLess(np.abs(s.energy() + 0.5).max(), 1e-8)
        self.assertLess(s.residual(), 50)

    def test_between_the_points_and_events_are_in_t(self):
        s = h.solve(h.variation(h.transform_time(kepler, h.sundman(1)), T, h.gauss(4)), **start)
        E = 2 * np.pi / 64 * 20.5
        self.assertLess(np.abs(s(E - e * np.sin(E)) - eccentric(E)).max(), 1e-4)
        passed = s.events(lambda t, q, p: q[1], crossing="falling")  # at the aphelia
        self.assertLess(np.abs(passed.t - np.pi * np.array([1, 3])).max(), 1e-4)
        self.assertRaises(h.OutsideDomain, s, 4 * np.pi + 1)

    def test_every_method_with_nodes(self):
        L = h.transform_time(kepler, h.sundman(1.5))
        exact = h.solve(h.variation(L, h.uniform(0, 0.02, 50), h.gauss(6)), **start)
        for method in (h.order_one, h.midpoint, h.theta(0.4), h.verlet, h.kahan_li_8, h.lobatto_3, h.Method("blanes-moan-4")):
            s = h.solve(h.variation(L, h.uniform(0, 0.02, 50), method), **start)
            self.assertLess(abs(s.t[-1] - exact.t[-1]) + np.abs(s.q[-1] - exact.q[-1]).max(), 0.2)
            self.assertLess(s.residual(), 1000)

    def test_fractions_and_many_digits(self):
        q, u = h.variables("q u")
        oscillator = h.transform_time(h.Lagrangian((u**2 - q**2) / 2, q, u), "2")
        s = h.solve(h.variation(oscillator, h.uniform(Fraction(1), Fraction(1, 10), 5), h.midpoint), q0=1, v0=1)
        self.assertEqual(list(s.t), [1 + Fraction(k, 5) for k in range(6)])
        try:
            from mpmath import mpf
        except ImportError:
            return
        s = h.solve(h.variation(oscillator, h.uniform(mpf(0), mpf(1) / 8, 4), h.gauss(8)), q0=1, v0=0)
        self.assertLess(abs(s.t[-1] - 1), mpf("1e-45"))

    def test_it_is_printed_compared_and_pickled(self):
        L = h.transform_time(kepler, h.sundman(1.5))
        self.assertIn("dt = (sundman(1.5)) dτ", repr(L))
        self.assertIn("d\\tau", h.variation(L, T, h.midpoint)._repr_latex_())
        self.assertNotEqual(L, kepler)
        for other in (pickle.loads(pickle.dumps(L)), copy.deepcopy(L), h.transform_time(kepler, "sundman(1.5)")):
            self.assertEqual(other, L)
            self.assertEqual(hash(other), hash(L))
            s, again = (h.solve(h.variation(M, h.uniform(0, 0.01, 3), h.midpoint), **start) for M in (L, other))
            self.assertTrue((s.t == again.t).all() and (s.q == again.q).all())
        again = pickle.loads(pickle.dumps(s))
        self.assertEqual(again(again.t[1] / 2)[0], s(s.t[1] / 2)[0])
        first = h.solve(h.variation(L, h.uniform(0, 0.01, 3), h.midpoint), until=lambda t, q, p: q[1] - 1e-9, **start)
        self.assertIn("passed zero", first.stopped)

    def test_what_has_no_constant_energy_is_refused(self):
        L = h.transform_time(kepler, h.sundman(1))
        EL = h.variation(L, T, h.midpoint)
        wrong = [
            lambda: EL + h.force("-v", "-w"),
            lambda: EL + h.damping(0.1, 0.5),
            lambda: EL + h.variation(kepler, T, h.order_one),
            lambda: h.variation(kepler, T, h.order_one) + EL,
            lambda: h.transform_time(L, h.sundman(1)),
            lambda: h.transform_time(h.Lagrangian("v^2/2 - t*q"), "1 + q^2"),
            lambda: h.transform_time(kepler, v**2),
            lambda: h.transform_time(kepler, h.t),
            lambda: h.solve(EL, q0=start["q0"], qN=[1, 1]),
            lambda: h.solve(EL, q0=start["q0"], q1=[0.1, 0.1]),
            lambda: h.solve(L, (0, 1), accuracy=1e-6, **start),
            lambda: h.solve_many(EL, q0=[start["q0"]], v0=[start["v0"]]),
            lambda: EL.c_code("step"),
            lambda: h.solve(h.variation(h.transform_time(kepler, x - y - 2), T, h.midpoint), **start),
        ]
        for work in wrong:
            with self.assertRaises(h.InvalidParameter):
                work()
        self.assertRaises(h.Unreadable, h.transform_time, kepler, "r")
        self.assertRaises(h.Mismatch, h.transform_time, kepler, h.inverse_potential(h.Lagrangian("v^2/2 - q^2/2")))
        self.assertRaises(TypeError, h.transform_time, EL, "1")
        self.assertRaises(TypeError, h.inverse_potential, "1")


if __name__ == "__main__":
    unittest.main()
