# SPDX-License-Identifier: BSL-1.0
"""Several velocities with one momentum, and Lagrangians that are not defined at rest: a motion begins with the velocity it is given."""

import unittest

import numpy as np

import hilger as h

cubic = h.Lagrangian("v^3/6 - q^2/2")  # v dv = -q dt
crystal = h.Lagrangian("v^4/12 - v^2/2 - q^2/2")
every_method = [h.order_one, h.order_one_left, h.midpoint, h.theta(0.3), h.verlet, h.gauss(2), h.gauss(4), h.lobatto_3, h.kahan_li_8]
T = h.uniform(0, 0.01, 10)


class Velocities(unittest.TestCase):
    def test_by_every_method(self):
        exact = 0.21151812818454024  # q(0.1) from q = 0.3, v = -0.9
        for method in every_method:
            x = h.solve(h.variation(cubic, T, method), q0=0.3, v0=-0.9)
            self.assertAlmostEqual(x.q[-1], exact, delta=1e-4 if method.name in ("verlet", "mid-point", "gauss-2") else 1e-3, msg=method.name)
            np.testing.assert_allclose(x.energy(), -(0.9**3) / 3 + 0.3**2 / 2, atol=0.02)
            self.assertAlmostEqual(x(0.001), 0.3 - 0.0009, delta=1e-5)
            self.assertLess(x.residual(), 64)
        x = h.solve(cubic, (0, 0.1), q0=0.3, v0=-0.9, accuracy=1e-9)
        self.assertAlmostEqual(x.q[-1], exact, delta=1e-9)

    def test_of_three(self):
        for v0 in (1.5, -1.5, 0.4, 1.2, -1.2):
            for method in every_method:
                x = h.solve(h.variation(crystal, h.uniform(0, 0.005, 2), method), q0=0.3, v0=v0)
                self.assertAlmostEqual((x.q[1] - x.q[0]) / 0.005, v0, delta=0.03, msg=method.name)
        several = h.solve_many(h.variation(crystal, h.uniform(0, 0.005, 2)), q0=[0.3, 0.3], v0=[1.5, -1.5], lanes=False)
        np.testing.assert_allclose((several.q[:, 1] - several.q[:, 0]).ravel() / 0.01, [1.5, -1.5], atol=0.03)

    def test_in_many_digits_and_fractions(self):
        import mpmath

        x = h.solve(h.variation(crystal, h.uniform(mpmath.mpf(0), mpmath.mpf("0.005"), 2)), q0=mpmath.mpf("0.3"), v0=mpmath.mpf("1.5"))
        self.assertAlmostEqual(float((x.q[1] - x.q[0]) / mpmath.mpf("0.005")), 1.5, delta=0.01)

    def test_where_nothing_is_at_rest(self):
        for text in ("v^4/4 - q^2/2", "sqrt(v)*v - q^2/2", "v*log(v) - q^2/2", "-log(v) - q^2/2", "v^4/4 + 1e-8*v^2/2 - q^2/2"):
            for method in every_method:
                x = h.solve(h.variation(h.Lagrangian(text), T, method), q0=0.3, v0=0.9)
                self.assertAlmostEqual((x.q[1] - x.q[0]) / 0.01, 0.9, delta=0.02, msg=f"{text}, {method.name}")
                self.assertLess(x.residual(), 64)

    def test_a_motion_that_ends(self):
        # v reaches 0 at t = 0.0655, where its speed changes without bound
        with self.assertRaisesRegex(h.NoConvergence, "the step from t = 0.06.* grows without bound"):
            h.solve(cubic, (0, 0.1), q0=0.3, v0=0.2, accuracy=1e-8)

    def test_poles_are_no_events(self):
        x = h.solve(h.variation(h.Lagrangian("v^2/2"), h.uniform(0, 0.125, 40)), q0=0.0, v0=1.0)
        with np.errstate(divide="ignore"):
            self.assertEqual(x.events(lambda t, q, p: 1 / (q - 0.55)).t.size, 0)
        np.testing.assert_allclose(x.events(lambda t, q, p: np.tan(q)).t, [np.pi], atol=1e-12)
        np.testing.assert_allclose(x.events(lambda t, q, p: q > 0.55).t, [0.55], atol=1e-12)


if __name__ == "__main__":
    unittest.main()
