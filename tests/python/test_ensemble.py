# SPDX-License-Identifier: BSL-1.0
"""Many at once: each member as if it were alone."""

import signal
import threading
import unittest
import warnings

import numpy as np

import hilger as h

q, v = h.variables("q v")
pendulum = h.Lagrangian(v**2 / 2 - (1 - h.cos(q)), q, v)
x, u = h.variables("x u", 2)
henon_heiles = h.Lagrangian(h.dot(u, u) / 2 - h.dot(x, x) / 2 - x[0] ** 2 * x[1] + x[1] ** 3 / 3, x, u)


class Ensemble(unittest.TestCase):
    def test_members_are_those_that_run_alone(self):
        EL = h.variation(henon_heiles, h.uniform(0, 0.1, 300), h.midpoint)
        rng = np.random.default_rng(1)
        q0, v0 = rng.uniform(-0.3, 0.3, (2, 40, 2))
        many = [h.solve_many(EL, q0=q0, v0=v0, every=7, threads=n) for n in (1, 2, 5)]
        for other in many[1:]:
            self.assertEqual(many[0].q.tobytes(), other.q.tobytes())
            self.assertEqual(many[0].p.tobytes(), other.p.tobytes())
        for k in (0, 17, 39):
            alone = h.solve(EL, q0=q0[k], v0=v0[k])
            self.assertEqual(many[0].q[k].tobytes(), np.concatenate([alone.q[::7], alone.q[-1:]]).tobytes())
            self.assertEqual(many[0].p[k].tobytes(), np.concatenate([alone.p[::7], alone.p[-1:]]).tobytes())
        self.assertEqual(list(many[0].t), [*alone.t[::7], alone.t[-1]])
        self.assertEqual(many[0].failed, {})

    def test_ends_alone_and_one_start_for_all(self):
        EL = h.variation(pendulum, h.uniform(0, 0.1, 50))
        many = h.solve_many(EL, q0=1.0, v0=np.linspace(-1, 1, 11))
        self.assertEqual(many.q.shape, (11, 2))
        self.assertTrue(np.all(many.q[:, 0] == 1))
        self.assertEqual(many.q[3, 1], h.solve(EL, q0=1.0, v0=np.linspace(-1, 1, 11)[3]).q[-1])

    def test_damped(self):
        EL = h.variation(pendulum, h.uniform(0, 0.1, 100)) + h.damping(0.2, 0.5)
        many = h.solve_many(EL, q0=[1.0, 2.0], v0=0.0, threads=2)
        self.assertEqual(many.q[1, -1], h.solve(EL, q0=2.0, v0=0.0).q[-1])

    def test_who_fails_loses_nobody_else(self):
        EL = h.variation(h.Lagrangian(v**2 / 2 + q**4, q, v), h.uniform(0, 0.1, 20))
        many = h.solve_many(EL, q0=[0.01, 3.0, 0.02], v0=0.0, every=1, threads=2)
        self.assertEqual(list(many.failed), [1])
        self.assertIn("the step from t = ", many.failed[1])
        self.assertTrue(np.isnan(many.q[1, -1]))
        self.assertTrue(np.all(np.isfinite(many.q[[0, 2]])))

    def test_an_interrupt_keeps_what_there_is(self):
        EL = h.variation(pendulum, h.uniform(0, 0.001, 1_000_000))
        timer = threading.Timer(0.5, lambda: signal.raise_signal(signal.SIGINT))
        timer.start()
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            many = h.solve_many(EL, q0=np.linspace(0, 1, 1000), v0=0.0, threads=2)
        self.assertIn("interrupted", many.failed.values())
        self.assertEqual([w.category for w in said], [RuntimeWarning])

    def test_progress(self):
        EL = h.variation(pendulum, h.uniform(0, 0.001, 100_000))
        seen = []
        h.solve_many(EL, q0=np.linspace(0, 1, 40), v0=0.0, progress=seen.append)
        self.assertEqual(seen, sorted(seen))

        def enough(_):
            raise LookupError("enough")

        with self.assertRaisesRegex(LookupError, "enough"):
            h.solve_many(EL, q0=np.linspace(0, 1, 100_000), v0=0.0, progress=enough)

    def test_times_where_the_first_member_fails(self):
        runs_away = h.Lagrangian("v^2/2 + q^4/4")
        many = h.solve_many(h.variation(runs_away, h.uniform(0, 0.5, 10)), q0=np.array([4.0, 0.0]), v0=0.0, every=4)
        self.assertEqual(list(many.failed), [0])
        self.assertEqual(list(many.t), [0, 2, 4, 5])

    def test_refused(self):
        EL = h.variation(henon_heiles, h.uniform(0, 0.1, 10))
        with self.assertRaisesRegex(h.Mismatch, "q0 has a row of 2 numbers for each member, and here is an array of shape .4, 3."):
            h.solve_many(EL, q0=np.zeros((4, 3)), v0=np.zeros(2))
        with self.assertRaisesRegex(h.Mismatch, "here are 4 and 3"):
            h.solve_many(EL, q0=np.zeros((4, 2)), v0=np.zeros((3, 2)))
        with self.assertRaisesRegex(h.InvalidParameter, "positive"):
            h.solve_many(EL, q0=np.zeros((4, 2)), v0=np.zeros(2), every=0)


if __name__ == "__main__":
    unittest.main()
