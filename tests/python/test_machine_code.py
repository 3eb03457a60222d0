# SPDX-License-Identifier: BSL-1.0
"""Machine code of formulas: the same numbers, kept for the next time, and never in the way."""

import os
import pathlib
import pickle
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

import needs
import numpy as np

import hilger as h
from hilger import _core, solving

epsilon = np.finfo(float).eps
METHODS = (h.order_one, h.midpoint, h.gauss(4), h.verlet, h.theta(0.3))


def problems():
    q, v = h.variables("q v")
    yield h.Lagrangian(v**2 / 2 - (1 - h.cos(q)), q, v), 1.0, 0.0
    yield h.Lagrangian(v**2 / 2 - h.where(q > 0, 2, 1) * q**2, q, v), 1.0, 0.0
    for d in (2, 3, 7):
        x, u = h.variables("x u", d)
        springs = sum((x[k + 1] - x[k]) ** 2 + h.cos(x[k]) for k in range(d - 1))
        yield h.Lagrangian(h.dot(u, u) / 2 + u[0] * u[1] / 4 - springs, x, u), np.linspace(0, 1, d), np.zeros(d)


class MachineCode(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        kept_there = unittest.mock.patch.dict(os.environ, XDG_CACHE_HOME=self.folder.name)
        kept_there.start()
        self.addCleanup(kept_there.stop)

    def tearDown(self):
        h.machine_code("on")
        self.folder.cleanup()

    @needs.c_compiler
    def test_every_bit_is_the_same(self):
        for L, q0, v0 in problems():
            for method in METHODS:
                EL = h.variation(L, h.uniform(0, 0.05, 1200), method)
                h.machine_code("off")
                interpreted = h.solve(EL, q0=q0, v0=v0)
                before = _core.formulas_in_machine_code()
                h.machine_code("at once")
                compiled = h.solve(EL, q0=q0, v0=v0)
                with self.subTest(L=L, method=method):
                    self.assertGreater(_core.formulas_in_machine_code(), before)
                    self.assertTrue(np.array_equal(interpreted.q, compiled.q))
                    self.assertTrue(np.array_equal(interpreted.p, compiled.p))

    def test_small_states_take_the_steps_of_any_others(self):
        """States of one to three numbers have an engine of their own under the mid-point embedding, and a scale that is not uniform has not."""
        for L, q0, v0 in problems():
            T = h.uniform(0, 0.0625, 200)
            x = h.solve(h.variation(L, T, h.midpoint), q0=q0, v0=v0)
            y = h.solve(h.variation(L, h.TimeScale([0.0625 * i for i in range(201)]), h.midpoint), q0=q0, v0=v0)
            np.testing.assert_allclose(x.q, y.q, rtol=0, atol=64 * epsilon * 200)
            self.assertLess(x.residual(), 64)
            for start in ({"p0": x.p[0]}, {"q1": x.q[1]}):
                z = h.solve(h.variation(L, T, h.midpoint), q0=q0, **start)
                np.testing.assert_allclose(x.q, z.q, rtol=0, atol=64 * epsilon * 200)

    @needs.c_compiler
    def test_in_the_middle_of_a_run(self):
        L, q0, v0 = next(problems())
        T = h.uniform(0, 0.01, 400_000)
        h.machine_code("off")
        interpreted = h.solve(h.variation(L, T, h.midpoint), q0=q0, v0=v0)
        h.machine_code("on")
        before = _core.formulas_in_machine_code()
        while _core.formulas_in_machine_code() == before:  # however long the compiler takes
            x = h.solve(h.variation(L, T, h.midpoint), q0=q0, v0=v0)
            self.assertTrue(np.array_equal(interpreted.q, x.q))

    @needs.c_compiler
    def test_ensemble(self):
        L = next(problems())[0]
        EL = h.variation(L, h.uniform(0, 0.05, 500), h.midpoint)
        h.machine_code("off")
        interpreted = h.solve_many(EL, q0=np.linspace(0, 1, 30), v0=0.0, threads=2)
        h.machine_code("at once")
        compiled = h.solve_many(EL, q0=np.linspace(0, 1, 30), v0=0.0, threads=2, lanes=False)
        self.assertTrue(np.array_equal(interpreted.q, compiled.q))

    @needs.c_compiler
    def test_whole_steps(self):
        """Steps that are machine code as a whole agree with the engine to rounding, and solve the equation."""
        q, v = h.variables("q v", 2)
        L = h.Lagrangian(h.dot(v, v) / 2 - h.dot(q, q) / 2 - q[0] ** 2 * q[1] + q[1] ** 3 / 3, q, v)
        x, u = h.variables("x u")
        pendulum = h.Lagrangian(u**2 / 2 + h.cos(x), x, u)
        N = 5000
        for method in (h.order_one, h.order_one_left, h.midpoint, h.verlet, h.kahan_li_8):
            for T in (h.uniform(0, 0.0625, N), h.TimeScale([0.0625 * i + 0.01 * np.sin(i) for i in range(N + 1)])):
                for equation, start in (
                    (h.variation(L, T, method), {"q0": [0.1, -0.05], "v0": [0.05, 0.1]}),
                    (h.variation(pendulum, T, method) + h.force(-u / 50), {"q0": 1, "p0": 0.25}),
                ):
                    if method is h.kahan_li_8 and equation.forces:
                        continue
                    with self.subTest(method=method, start=start):
                        alone, whole = (h.solve(equation, **start, compiled=how) for how in (False, True))
                        self.assertFalse(alone.compiled)
                        self.assertTrue(whole.compiled)
                        self.assertTrue(np.array_equal(alone.t, whole.t))
                        np.testing.assert_allclose(whole.q, alone.q, rtol=0, atol=16 * N * epsilon)
                        np.testing.assert_allclose(whole.p, alone.p, rtol=0, atol=16 * N * epsilon)
                        self.assertEqual(whole.q.shape, alone.q.shape)
                        if method in (h.order_one, h.midpoint):
                            self.assertLess(whole.residual(), 64)

    @needs.c_compiler
    def test_whole_steps_where_they_are_not(self):
        x, u = h.variables("x u")
        oscillator = h.Lagrangian(u**2 / 2 - x**2 / 2, x, u)
        T = h.uniform(0, 0.125, 100)
        for equation in (
            h.variation(oscillator, T, h.gauss(4)),
            h.variation(oscillator, T) + h.damping(0.2, 0.5),
            h.variation(h.Lagrangian(u**2 / 2 - abs(x), x, u), T),
        ):
            alone, whole = (h.solve(equation, q0=1, v0=0, compiled=how) for how in (False, True))
            self.assertFalse(whole.compiled)
            self.assertTrue(np.array_equal(alone.q, whole.q))
        h.machine_code("off")
        self.assertFalse(h.solve(h.variation(oscillator, T), q0=1, v0=0, compiled=True).compiled)
        h.machine_code("on")
        # a step that fails is told by the engine, with what there is
        cubic = h.Lagrangian(u**2 / 2 + 10 * x**3 / 3, x, u)
        with self.assertRaisesRegex(h.StepFailure, "the step from") as failed:
            h.solve(h.variation(cubic, T), q0=1, v0=0, compiled=True)
        self.assertGreater(len(failed.exception.solution), 1)
        self.assertFalse(failed.exception.solution.compiled)
        for how in (1, "yes"):
            with self.assertRaisesRegex(h.InvalidParameter, "compiled is True, False or None"):
                h.solve(h.variation(oscillator, T), q0=1, v0=0, compiled=how)

    @needs.c_compiler
    def test_whole_steps_of_long_runs(self):
        """Many steps take them without being asked for; progress and pickles are as they were."""
        x, u = h.variables("x u")
        N = 100_000
        EL = h.variation(h.Lagrangian(u**2 / 2 - x**2 / 2, x, u), h.uniform(0, 0.01, N))
        told = []
        self.assertEqual(solving.LONG, 10_000_000)
        with unittest.mock.patch.object(solving, "LONG", N):
            long_one = h.solve(EL, q0=1, v0=0, progress=told.append)
            short_one = h.solve(h.variation(EL.lagrangian, h.uniform(0, 0.01, N - 1)), q0=1, v0=0)
            engine = h.solve(EL, q0=1, v0=0, compiled=False)
        self.assertEqual([x.compiled for x in (long_one, short_one, engine)], [True, False, False])
        self.assertEqual(told[-1], N)
        self.assertEqual(told, sorted(told))
        w = 2 / 0.01 * np.arctan(0.005)  # the frequency of the mid-point rule
        np.testing.assert_allclose(long_one.q, np.cos(w * 0.01 * np.arange(N + 1)), rtol=0, atol=N * epsilon)
        again = pickle.loads(pickle.dumps(h.solve(EL, q0=1, v0=0, compiled=True)))
        self.assertTrue(again.compiled)
        self.assertTrue(np.array_equal(again.q, long_one.q))

    def test_where_nothing_can_be_kept_or_compiled(self):
        program = (
            "import hilger as h\n"
            "x = h.solve(h.variation(h.Lagrangian('v^2/2 - q^4'), h.uniform(0, 0.01, 3000)), q0=1.0, v0=0.0)\n"
            "print(repr(float(x.q[-1])), h._core.formulas_in_machine_code())"
        )

        def run(**variables):
            environment = {**os.environ, **variables}
            done = subprocess.run([sys.executable, "-c", program], env=environment, capture_output=True, text=True, check=True)
            return done.stdout.split(), done.stderr

        (expected, none), said = run(HILGER_MACHINE_CODE="off")
        self.assertEqual((none, said), ("0", ""))
        self.assertEqual(run(XDG_CACHE_HOME="/dev/null/nowhere"), ([expected, "0"], ""))
        (number, none), said = run(CC="/nowhere/cc")
        self.assertEqual((number, none), (expected, "0"))
        self.assertEqual(said.count("there is no C compiler"), 1)
        leftovers = [file for file in pathlib.Path(self.folder.name).rglob("*") if file.suffix in (".c", ".so") and "." in file.stem]
        self.assertEqual(leftovers, [])

    def test_refused(self):
        with self.assertRaisesRegex(h.InvalidParameter, '"on", "off" or "at once", and not "yes"'):
            h.machine_code("yes")


if __name__ == "__main__":
    unittest.main()
