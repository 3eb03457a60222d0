# SPDX-License-Identifier: BSL-1.0
"""Loads that switch in time: right values are closed forms, or a Laplace transform in mpmath."""

import math
import unittest

import hilger as h

q, v = h.variables("q v")
oscillator = v**2 / 2 - q**2 / 2


def behind(s, t):
    """What a push of one from t = s on makes of an oscillator at rest."""
    return 1 - math.cos(t - s) if t > s else 0.0


class OfAccurateSolutions(unittest.TestCase):
    def meets(self, push, exact, accuracy, end=20, **more):
        x = h.solve(h.Lagrangian(oscillator + q * push, q, v), (0, end), q0=0.0, v0=0.0, accuracy=accuracy, **more)
        self.assertLess(max(abs(y - exact(t)) for t, y in zip(x.t, x.q)), accuracy)
        self.assertLess(abs(x(end / math.e) - exact(end / math.e)), accuracy)
        self.assertTrue(0 < x.error <= accuracy)
        return x

    def test_a_push_that_is_narrow(self):
        push, exact = h.where(abs(h.t - 7) < 0.01, 100, 0), lambda t: 100 * (behind(6.99, t) - behind(7.01, t))
        self.assertAlmostEqual(exact(20), 0.8403200681553974, delta=1e-12)
        for longest in (0.0, 0.005):
            x = self.meets(push, exact, 1e-8, longest_step=longest)
            for t in (6.99, 7.01):
                self.assertLess(min(abs(x.t - t)), 1e-13)

    def test_two_pushes(self):
        push = h.where(abs(h.t - 3) < 0.001, 1000, 0) - h.where(abs(h.t - 11.1) < 0.003, 50, 0)
        self.meets(push, lambda t: 1000 * (behind(2.999, t) - behind(3.001, t)) - 50 * (behind(11.097, t) - behind(11.103, t)), 1e-9)

    def test_a_step_at_an_irrational_time(self):
        for accuracy in (1e-1, 1e-4, 1e-11):
            self.meets(h.where(h.t < h.sqrt(2), 0, 1), lambda t: behind(math.sqrt(2), t), accuracy, 10)

    def test_a_kink(self):
        def exact(t):
            s = t - math.pi
            return -s - math.pi * math.cos(t) + math.sin(t) if s < 0 else s + math.pi * math.cos(s) - 3 * math.sin(s)

        x = self.meets(abs(h.t - h.pi), exact, 1e-10, 10)
        self.assertLess(len(x), 1000)
        self.assertLess(abs(x.events(lambda t, q, p: q - 1).q - 1).max(), 1e-9)
        self.assertLess(x.residual(), 64)

    def test_a_force(self):
        x = h.solve(h.Lagrangian(oscillator + q * h.where(h.t < 2, 0, 1), q, v), (0, 9), q0=0.0, v0=0.0, accuracy=1e-9)
        self.assertAlmostEqual(x.q[-1], behind(2, 9), delta=1e-9)

    def test_few_points_where_nothing_switches(self):
        x = h.solve(h.Lagrangian(oscillator + q * h.sin(h.t), q, v), (0, 9), q0=0.0, v0=0.0, accuracy=1e-9)
        self.assertLess(len(x), 64)  # of at most a thirty-second of the interval


class OfNewmark(unittest.TestCase):
    """u'' + D^(3/2) u + u = a load, from rest."""

    def exact(self, jumps, t):
        import mpmath

        with mpmath.workdps(30):
            s = lambda z: 1 / (z * (z**2 + z ** mpmath.mpf("1.5") + 1))  # of a step of one
            return float(sum(by * mpmath.invertlaplace(s, mpmath.mpf(t) - at, method="talbot") for at, by in jumps if at < t))

    def test_the_order_is_two(self):
        L = h.Lagrangian(oscillator, q, v)
        for load, jumps in (
            (h.where(h.t <= 1, 8, 0), ((0, 8), (1, -8))),  # on a point
            (h.where(h.t < 1, 8, 0), ((0, 8), (1, -8))),
            (h.where(h.t < h.sqrt(2), 8, 0), ((0, 8), (math.sqrt(2), -8))),  # within a step
            (h.where(abs(h.t - 1.3) < 0.002, 1000, 0), ((1.298, 1000), (1.302, -1000))),  # both within one
        ):
            right = self.exact(jumps, 2)
            if jumps[1] == (1, -8):
                self.assertAlmostEqual(right, 4.425462195858, delta=1e-11)
            for steps in (200, 400, 800):
                x = h.solve(h.variation(L, h.uniform(0, 2 / steps, steps), h.g_alpha_newmark) + h.force(load) + h.damping(1, alpha=1.5), q0=0, v0=0)
                self.assertLess(abs(x.q[-1] - right), 4 * (2 / steps) ** 2)  # of order one up to 8 h

    def test_the_case_of_a_load_up_to_one(self):
        x = h.solve(
            h.variation(h.Lagrangian(oscillator, q, v), h.uniform(0, 1 / 80, 800), h.g_alpha_newmark) + h.force(h.where(h.t <= 1, 8, 0)) + h.damping(1, alpha=1.5),
            q0=0,
            v0=0,
        )
        for t, right in ((1, 2.315525822793), (2, 4.425462195858), (5, -0.455641340538), (10, 0.531619865859)):
            self.assertAlmostEqual(x.q[80 * t], right, delta=4 / 80**2)


if __name__ == "__main__":
    unittest.main()
