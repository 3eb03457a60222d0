# SPDX-License-Identifier: BSL-1.0
"""Problems between two ends with no, one and two solutions: what is right is found, and what is not is refused or doubted in one sentence."""

import unittest
import warnings

import hilger as h
import numpy as np

q, v = h.variables("q v")
oscillator = h.Lagrangian(v**2 / 2 - q**2 / 2, q, v)
catenoid = h.Lagrangian(q * h.sqrt(1 + v**2), q, v)
descent = h.Lagrangian(h.sqrt((1 + v**2) / (2 * q)), q, v)


def between(L, start, end, steps, first, last, method=h.midpoint, guess=None):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        x = h.solve(h.variation(L, h.uniform(start, (end - start) / steps, steps), method), q0=first, qN=last, guess=guess)
    return x, [str(w.message) for w in caught if w.category is h.DoubtfulSolution]


class TwoEnds(unittest.TestCase):
    def test_half_a_period_apart(self):
        for steps, response in ((100, 7741), (300, 69664)):  # 2 / |sin(2 N atan(h / 2))|
            x, doubts = between(oscillator, 0, np.pi, steps, 0, 1)
            self.assertEqual(len(doubts), 1)
            self.assertIn(f"it changes by {response}", doubts[0])
            self.assertLess(x.residual(), 16)
        for method, steps in ((h.midpoint, 10000), (h.gauss(2), 300)):
            with self.assertRaisesRegex(h.IllConditioned, "the ends hardly determine what lies between them"):
                between(oscillator, 0, np.pi, steps, 0, 1, method)
        x, doubts = between(oscillator, 0, 1, 100, 0, np.sin(1))
        self.assertEqual(doubts, [])
        self.assertLess(np.abs(x.q - np.sin(x.t)).max(), 1e-5)

    def test_catenoids(self):
        x, doubts = between(catenoid, -0.5, 0.5, 100, 1, 1)
        self.assertEqual(doubts, [])
        self.assertAlmostEqual(x.q[50], 0.848337938094979, 4)
        self.assertLess(x.residual(), 16)
        for half, steps in ((0.70, 200), (1.0, 100)):  # none from 0.66274 on
            with self.assertRaisesRegex(h.NoConvergence, "the equation between the ends of T"):
                between(catenoid, -half, half, steps, 1, 1)

    def test_fastest_descent(self):
        width, depth = 1.0907025731743183, 1.4161468365471424
        with self.assertRaisesRegex(h.NotFinite, "at t = 0, q = 0, where the first guess between the ends of T"):
            between(descent, 0, width, 100, 0, depth)
        _, doubts = between(descent, 0, width, 100, 0.01, depth)
        self.assertIn("the solution may be near no motion: on every second point it is", doubts[0])
        _, doubts = between(descent, 0, width, 400, 0.1, depth)
        self.assertEqual(doubts, [])

    def test_the_residual_is_in_roundings(self):
        pendulum = h.Lagrangian(v**2 / 2 + h.cos(q), q, v)
        for method in (h.midpoint, h.order_one, h.verlet, h.gauss(2), h.kahan_li_8):
            for step in (0.1, 1e-3, 1e-6):
                x = h.solve(h.variation(pendulum, h.uniform(0, step, 100), method), q0=1, v0=0.5)
                self.assertLess(x.residual(), 64, (method.name, step))
                self.assertLess(x.residual(absolute=True), 1e4 * np.finfo(float).eps / step**2)
            x.q[50] += 1e-6
            self.assertGreater(x.residual(), 1e6)
        damped = h.variation(pendulum, h.uniform(0, 1e-3, 100), h.midpoint) + h.damping(0.1, 0.5)
        self.assertLess(h.solve(damped, q0=1, v0=0.5).residual(), 16)
        x = h.solve(h.variation(pendulum, h.uniform(0, 0.01, 100), h.two_sided(0.75)), q0=0, qN=1)
        self.assertLess(x.residual(), 16)


if __name__ == "__main__":
    unittest.main()
