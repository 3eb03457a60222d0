# SPDX-License-Identifier: BSL-1.0
"""Many at once: each member as if it were alone."""

import importlib.util
import shutil
import signal
import subprocess
import sys
import threading
import unittest
import warnings

import needs
import numpy as np

import hilger as h

epsilon = np.finfo(float).eps
q, v = h.variables("q v")
pendulum = h.Lagrangian(v**2 / 2 - (1 - h.cos(q)), q, v)
x, u = h.variables("x u", 2)
henon_heiles = h.Lagrangian(h.dot(u, u) / 2 - h.dot(x, x) / 2 - x[0] ** 2 * x[1] + x[1] ** 3 / 3, x, u)


class Ensemble(unittest.TestCase):
    def test_members_are_those_that_run_alone(self):
        EL = h.variation(henon_heiles, h.uniform(0, 0.1, 300), h.midpoint)
        rng = np.random.default_rng(1)
        q0, v0 = rng.uniform(-0.3, 0.3, (2, 40, 2))
        many = [h.solve_many(EL, q0=q0, v0=v0, every=7, threads=n, lanes=False) for n in (1, 2, 5)]
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
        for lanes, rounding in ((False, 0), (True, 50 * epsilon)):
            many = h.solve_many(EL, q0=1.0, v0=np.linspace(-1, 1, 11), lanes=lanes)
            self.assertEqual(many.q.shape, (11, 2))
            self.assertTrue(np.all(many.q[:, 0] == 1))
            self.assertAlmostEqual(many.q[3, 1], h.solve(EL, q0=1.0, v0=np.linspace(-1, 1, 11)[3]).q[-1], delta=rounding)

    def test_parameters_that_are_called_as_initial_values_are(self):
        for name, other in (("q0", "v0"), ("v0", "v0"), ("p0", "p0"), ("p0", "v0"), ("q1", "q1")):
            L = h.Lagrangian(f"v^2/2 - k*(q - {name})^2/2", **{"k": 1, name: 0})
            T, values = h.uniform(0, 0.1, 10), {"k": [1.0, 2.0, 3.0], name: [1.0, 2.0, -3.0]}
            for lanes in (False, True):
                for parameters in (values, dict(reversed(values.items()))):
                    many = h.solve_many(h.variation(L, T), q0=[5.0, 4.0, 3.0], **{other: [0.5, 4.1, 3.0]}, parameters=parameters, lanes=lanes)
                    self.assertEqual(many.failed, {})
                    for i in range(3):
                        own = h.Lagrangian(f"v^2/2 - k*(q - {name})^2/2", **{k: x[i] for k, x in values.items()})
                        x = h.solve(h.variation(own, T), q0=5.0 - i, **{other: [0.5, 4.1, 3.0][i]})
                        self.assertAlmostEqual(many.q[i, -1], x.q[-1], delta=50 * epsilon * 10)

    def test_members_of_another_width_are_no_members(self):
        EL = h.variation(henon_heiles, h.uniform(0, 0.1, 3))
        two, one = np.ones((4, 2)), np.ones((4, 1))
        none = np.empty((4, 0))
        for lanes in (False, True):
            cast = h._core.Cast(EL._stated(), "mid-point", lanes, (0.0, 0.1, 3))
            for q0, v0, parameters in ((one, two, none), (two, one, none)):
                with self.assertRaisesRegex(h.Mismatch, "a member has 2 coordinates and brings 0 parameters"):
                    h._core.walk_all(cast, q0, "v0", v0, parameters, 1, 1, None)

    def test_where_none_comes_to_the_end(self):
        EL = h.variation(h.Lagrangian("v^2/2 - k*q^2/2", k=1), h.uniform(0, 0.1, 3))
        for lanes in (False, True):
            with self.assertWarnsRegex(RuntimeWarning, "no member came to the end; the first: "):
                many = h.solve_many(EL, q0=[1.0, 2.0], v0=0.0, parameters={"k": [np.nan, np.inf]}, lanes=lanes)
            self.assertEqual(sorted(many.failed), [0, 1])
            self.assertTrue(np.isnan(many.q[:, -1]).all())
        with self.assertRaisesRegex(h.InvalidParameter, "k is an array of numbers"):
            h.solve_many(EL, q0=[1.0, 2.0], v0=0.0, parameters={"k": [1.0, None]})

    @needs.c_compiler
    def test_lanes_agree_with_those_alone_and_do_not_know_of_each_other(self):
        rng = np.random.default_rng(2)
        q0, v0 = rng.uniform(-0.3, 0.3, (2, 21, 2))
        for T in (h.uniform(0, 0.125, 200), h.TimeScale(list(np.cumsum(0.125 + 0.0625 * np.sin(np.arange(200)))))):
            for method in (h.midpoint, h.order_one, h.order_one_left, h.verlet, h.kahan_li_8, h.theta(0.5), h.gauss(2)):
                EL = h.variation(henon_heiles, T, method)
                alone = h.solve_many(EL, q0=q0, v0=v0, every=1, lanes=False)
                many = h.solve_many(EL, q0=q0, v0=v0, every=1, threads=1)
                for other in (h.solve_many(EL, q0=q0, v0=v0, every=1, threads=3), h.solve_many(EL, q0=q0, v0=v0, every=1)):
                    self.assertEqual(many.q.tobytes(), other.q.tobytes())
                    self.assertEqual(many.p.tobytes(), other.p.tobytes())
                self.assertEqual(many.lanes > 1, method != h.gauss(2))
                part = h.solve_many(EL, q0=q0[5:8], v0=v0[5:8], every=200)
                self.assertEqual(many.q[5:8, -1].tobytes(), part.q[:, -1].tobytes())
                np.testing.assert_allclose(many.q, alone.q, rtol=0, atol=200 * 16 * epsilon)
                np.testing.assert_allclose(many.p, alone.p, rtol=0, atol=200 * 16 * epsilon)
                if method in (h.midpoint, h.order_one):
                    for start in ({"p0": many.p[:, 0]}, {"q1": many.q[:, 1]}):
                        again = h.solve_many(EL, q0=q0, every=1, **start)
                        np.testing.assert_allclose(again.q, many.q, rtol=0, atol=200 * 64 * epsilon)

    @needs.c_compiler
    def test_parameters_of_members(self):
        L = h.Lagrangian("m*v^2/2 - k[0]*q^2/2 - k[1]*q^4/4 - g*q", m=1, k=[1, 2], g=0)
        m, g = np.linspace(1, 2, 11), np.linspace(-0.25, 0.25, 11)
        k = np.column_stack([np.linspace(0.5, 1.5, 11), np.linspace(2, 3, 11)])
        for method in (h.midpoint, h.order_one, h.verlet):
            EL = h.variation(L, h.uniform(0, 0.125, 64), method) + h.force(-v * h.variables("g") / 8)
            for start in ({"v0": 0.5}, {"p0": 0.5}):
                many = h.solve_many(EL, q0=0.5, parameters={"m": m, "k": k, "g": g}, **start)
                by_one = h.solve_many(EL, q0=0.5, parameters={"m": m, "k": k, "g": g}, lanes=False, **start)
                self.assertEqual((many.failed, by_one.failed), ({}, {}))
                self.assertEqual((many.lanes > 1, by_one.lanes), (True, 1))
                for n in (0, 4, 10):
                    own = h.Lagrangian("m*v^2/2 - k[0]*q^2/2 - k[1]*q^4/4 - g*q", m=m[n], k=list(k[n]), g=g[n])
                    alone = h.solve(h.variation(own, EL.scale, method) + h.force(-v * h.variables("g") / 8), q0=0.5, **start)
                    self.assertEqual(by_one.q[n, -1], alone.q[-1])
                    self.assertAlmostEqual(many.q[n, -1], alone.q[-1], delta=64 * 16 * epsilon)
                    self.assertAlmostEqual(many.p[n, -1], alone.p[-1], delta=64 * 16 * epsilon)
        same = h.solve_many(EL, q0=[0.5, 0.25], v0=0.5, parameters={"k": [1.0, 2.0]})
        usual = h.solve_many(EL, q0=[0.5, 0.25], v0=0.5)
        np.testing.assert_allclose(same.q, usual.q, rtol=0, atol=64 * 16 * epsilon)
        with self.assertRaisesRegex(h.InvalidParameter, "there is no parameter 'kappa': there are g, k, m"):
            h.solve_many(EL, q0=0.5, v0=0.5, parameters={"kappa": k})
        with self.assertRaisesRegex(h.Mismatch, "k has 2 numbers for each member, and here is an array of shape .11, 3."):
            h.solve_many(EL, q0=0.5, v0=0.5, parameters={"k": np.ones((11, 3))})
        with self.assertRaisesRegex(h.Mismatch, "here are 1 of q0, 1 of v0, 11 of m, 5 of g"):
            h.solve_many(EL, q0=0.5, v0=0.5, parameters={"m": m, "g": g[:5]})

    @unittest.skipUnless(shutil.which("mpirun") and importlib.util.find_spec("mpi4py"), "there is no MPI here")
    def test_ranks(self):
        program = (
            "import hashlib, sys\n"
            "import numpy as np, hilger as h\n"
            "from mpi4py import MPI\n"
            "EL = h.variation(h.Lagrangian('v^2/2 + q^4', 'q', 'v'), h.uniform(0, 0.1, 20))\n"
            "many = h.solve_many(EL, q0=np.linspace(0.01, 3, 13), v0=0.0, every=1, comm=MPI.COMM_WORLD)\n"
            "few = h.solve_many(EL, q0=[0.01, 0.02], v0=0.0, comm=MPI.COMM_WORLD)\n"
            "assert few.q.shape == (2, 2) and not few.failed\n"
            "made = hashlib.sha256(many.q.tobytes() + many.p.tobytes()).hexdigest(), sorted(many.failed), many.q.shape\n"
            "all_of_them = MPI.COMM_WORLD.gather(made)\n"
            "if MPI.COMM_WORLD.Get_rank() == 0:\n"
            "    print(len(all_of_them), all(x == made for x in all_of_them), *made)\n"
        )
        said = []
        for ranks in (1, 4):
            command = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", str(ranks), sys.executable, "-c", program]
            count, same, made = subprocess.run(command, capture_output=True, text=True, check=True).stdout.split(" ", 2)
            self.assertEqual((int(count), same), (ranks, "True"))
            said.append(made)
        self.assertEqual(said[0], said[1])
        self.assertRegex(said[0], r"\[.*12\] \(13, 21\)")

    def test_without_machine_code_members_are_alone(self):
        EL = h.variation(pendulum, h.uniform(0, 0.125, 100))
        h.machine_code("off")
        try:
            many = h.solve_many(EL, q0=np.linspace(0, 2, 9), v0=0.5)
        finally:
            h.machine_code("on")
        self.assertEqual(many.lanes, 1)
        self.assertTrue(np.array_equal(many.q, h.solve_many(EL, q0=np.linspace(0, 2, 9), v0=0.5, lanes=False).q))

    def test_damped(self):
        EL = h.variation(pendulum, h.uniform(0, 0.1, 100)) + h.damping(0.2, 0.5)
        many = h.solve_many(EL, q0=[1.0, 2.0], v0=0.0, threads=2)  # no lanes with a memory
        self.assertEqual(many.q[1, -1], h.solve(EL, q0=2.0, v0=0.0).q[-1])

    def test_who_fails_loses_nobody_else(self):
        EL = h.variation(h.Lagrangian(v**2 / 2 + q**4, q, v), h.uniform(0, 0.1, 20))
        many = h.solve_many(EL, q0=[0.01, 3.0, 0.02], v0=0.0, every=1, threads=2)
        self.assertEqual(list(many.failed), [1])
        self.assertIn("the step from t = ", many.failed[1])
        self.assertTrue(np.isnan(many.q[1, -1]))
        self.assertTrue(np.all(np.isfinite(many.q[[0, 2]])))
        alone = h.solve_many(EL, q0=[0.01, 3.0, 0.02], v0=0.0, every=1, lanes=False)
        self.assertEqual(many.failed, alone.failed)
        self.assertEqual(many.q[1].tobytes(), alone.q[1].tobytes())

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
        self.assertEqual((seen[-1], seen), (40, sorted(seen)))

        self.assertEqual(len(h.solve_many(EL, q0=[0.0, 1.0], v0=0.0, progress=True)), 2)
        self.assertRaisesRegex(h.InvalidParameter, "progress is True, for a bar", h.solve_many, EL, q0=[0.0, 1.0], v0=0.0, progress=3)
        self.assertRaisesRegex(h.InvalidParameter, "lanes is True or False", h.solve_many, EL, q0=[0.0, 1.0], v0=0.0, lanes="no")

        def enough(_):
            raise LookupError("enough")

        with self.assertRaisesRegex(LookupError, "enough"):
            h.solve_many(EL, q0=np.linspace(0, 1, 100_000), v0=0.0, progress=enough)

    def test_times_where_the_first_member_fails(self):
        runs_away = h.Lagrangian("v^2/2 + q^4/4")
        many = h.solve_many(h.variation(runs_away, h.uniform(0, 0.5, 10)), q0=np.array([4.0, 0.0]), v0=0.0, every=4, lanes=False)
        self.assertEqual(list(many.failed), [0])
        self.assertEqual(list(many.t), [0, 2, 4, 5])

    def test_no_members(self):
        EL = h.variation(pendulum, h.uniform(0, 0.1, 3), h.midpoint)
        self.assertEqual(h.solve_many(EL, q0=[], v0=0.0).q.shape[0], 0)
        self.assertEqual(h.solve_many(EL, q0=1.0, v0=np.empty(0)).q.shape[0], 0)
        with self.assertRaisesRegex(h.Mismatch, "0 of q0, 2 of v0"):
            h.solve_many(EL, q0=[], v0=[0.0, 1.0])

    def test_arrays_that_are_no_numbers(self):
        EL = h.variation(pendulum, h.uniform(0, 0.1, 3), h.midpoint)
        masked = np.ma.masked_array([1.0, 2.0], mask=[False, True])
        with self.assertRaisesRegex(h.InvalidParameter, "q0 has masked numbers"):
            h.solve_many(EL, q0=masked, v0=0.0)
        self.assertEqual(h.solve_many(EL, q0=masked[~masked.mask], v0=0.0).q.shape[0], 1)
        for wrong in (np.array([10**400, 1], dtype=object), np.array([1j, 1], dtype=object), ["one", 1]):
            with self.assertRaisesRegex(h.InvalidParameter, "v0 is an array of numbers that a double can be"):
                h.solve_many(EL, q0=1.0, v0=wrong)

    def test_what_is_not_asked_for_is_not_kept(self):
        import resource

        steps = 8_000_000  # the times of all of them are 64 MB
        EL = h.variation(h.Lagrangian("v^2/2 - q^2/2"), h.uniform(0, 1e-3, steps), h.verlet)
        h.solve_many(h.variation(h.Lagrangian("v^2/2 - q^2/2"), h.uniform(0, 1e-3, 10), h.verlet), q0=np.ones(8), v0=0.0)
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        made = h.solve_many(EL, q0=np.ones(8), v0=0.0)
        self.assertEqual(made.t.tolist(), [0, 8000])
        self.assertLess(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before, 16_000)  # kB

    def test_refused(self):
        EL = h.variation(henon_heiles, h.uniform(0, 0.1, 10))
        with self.assertRaisesRegex(h.Mismatch, "q0 has a row of 2 numbers for each member, and here is an array of shape .4, 3."):
            h.solve_many(EL, q0=np.zeros((4, 3)), v0=np.zeros(2))
        with self.assertRaisesRegex(h.Mismatch, "here are 4 of q0, 3 of v0"):
            h.solve_many(EL, q0=np.zeros((4, 2)), v0=np.zeros((3, 2)))
        with self.assertRaisesRegex(h.InvalidParameter, "every is a whole number, and was 1.5"):
            h.solve_many(EL, q0=np.zeros((4, 2)), v0=np.zeros(2), every=1.5)
        with self.assertRaisesRegex(h.InvalidParameter, "parameters are given by their names"):
            h.solve_many(EL, q0=np.zeros((4, 2)), v0=np.zeros(2), parameters=[1])
        with self.assertRaisesRegex(h.InvalidParameter, "positive"):
            h.solve_many(EL, q0=np.zeros((4, 2)), v0=np.zeros(2), every=0)


if __name__ == "__main__":
    unittest.main()
