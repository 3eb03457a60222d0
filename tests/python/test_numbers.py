# SPDX-License-Identifier: BSL-1.0
"""Numbers keep their digits on the way into formulas, failures their solution, and what is shown says all of the equation."""

import copy
import pickle
import signal
import threading
import unittest
import warnings
from decimal import Decimal
from fractions import Fraction

import numpy as np

import hilger as h

try:
    import mpmath
except ImportError:
    mpmath = None

q, v = h.variables("q v")
oscillator = h.variation(h.Lagrangian(v**2 / 2 - q**2 / 2, q, v), h.uniform(0, 0.1, 10))


class Digits(unittest.TestCase):
    def test_functions_of_numbers_are_exact_or_refused(self):
        T = h.uniform(0, Fraction(1, 10), 3)
        with self.assertRaisesRegex(h.Unreadable, "sqrt has no exact value in rationals"):
            h.solve(h.variation(h.Lagrangian(v**2 / 2 - h.sqrt(2) * q, q, v), T), q0=0, v0=0)
        self.assertEqual(float(h.cos(0)), 1.0)
        self.assertEqual(float(h.sqrt(2) * h.pi / 4 + 1), np.sqrt(2) * np.pi / 4 + 1)
        for formula in (q, h.sqrt(q), h.t):
            with self.assertRaisesRegex(TypeError, "a formula of numbers alone is a number"):
                float(formula)
        with self.assertRaisesRegex(h.InvalidParameter, "the parameter k is a number or a list of numbers: .*here is the formula"):
            h.Lagrangian("v^2/2 - k*q", k=h.sqrt(2))

    @unittest.skipIf(mpmath is None, "mpmath is not here")
    def test_fifty_digits(self):
        with mpmath.workdps(50):
            T = h.uniform(mpmath.mpf(0), mpmath.mpf(1) / 10, 20)
            root, third = mpmath.sqrt(2), mpmath.mpf(1) / 3
        ends = []
        # outside of workdps: with what mpf has, and not with the digits that are usual here
        for L in (h.Lagrangian("v^2/2 - sqrt(2)*q^2/2"), h.Lagrangian(v**2 / 2 - h.sqrt(2) * q**2 / 2, q, v), h.Lagrangian(v**2 / 2 - root * q**2 / 2, q, v)):
            ends.append(h.solve(h.variation(L, T), q0=third, v0=0).q[-1])
        with mpmath.workdps(50):
            for end in ends[1:]:
                self.assertLess(abs(end - ends[0]), mpmath.mpf("1e-48"))

    @unittest.skipIf(mpmath is None, "mpmath is not here")
    def test_order_16_in_fifty_digits(self):
        oscillator = h.Lagrangian(v**2 / 2 - q**2 / 2, q, v)
        errors = []
        with mpmath.workdps(50):
            # a velocity has the rounding of positions times the slopes of a polynomial of degree 8, 2 8^2/h, and a row of it once more
            rounding = lambda h: (128 / h) ** 2 * mpmath.mpf(2) ** -167
            for steps in (4, 8):
                x = h.solve(h.variation(oscillator, h.uniform(mpmath.mpf(0), mpmath.mpf(2) / steps, steps), h.gauss(8)), q0=1, v0=0)
                errors.append(abs(x.q[-1] - mpmath.cos(2)))
                self.assertLess(x.residual(), 64)
                self.assertLess(max(abs(e - x.energy()[0]) for e in x.energy()), mpmath.mpf("1e-47"))
            self.assertAlmostEqual(float(mpmath.log(errors[0] / errors[1], 2)), 16, delta=0.02)
            # a pendulum with friction, on points that are given, and between its ends
            swung = h.Lagrangian(v**2 / 2 - (1 - h.cos(q)), q, v)
            T = h.TimeScale([mpmath.mpf(k) / 10 + mpmath.mpf(k * k) / 100 for k in range(6)])
            x = h.solve(h.variation(swung, T, h.gauss(8)), q0=mpmath.mpf(1), v0=0)
            again = h.solve(h.variation(swung, T, h.gauss(8)), q0=x.q[0], qN=x.q[-1])
            self.assertLess(max(abs(y - z) for y, z in zip(again.q, x.q)), mpmath.mpf("1e-46"))
            rough = h.solve(h.variation(swung, h.TimeScale([float(t) for t in x.t]), h.gauss(8)), q0=1, v0=0)
            self.assertLess(max(abs(float(y) - z) for y, z in zip(x.q, rough.q)), 1e-15)
            rubbed = h.solve(h.variation(swung, T, h.gauss(8)) + h.force(-v / 10), q0=1, v0=0)
            self.assertLess(rubbed.energy()[-1], x.energy()[-1])
            self.assertLess(rubbed.residual(), 64)
        with self.assertRaisesRegex(h.InvalidParameter, "in 50 digits the methods are .*mid-point, theta:0.3, verlet, kahan-li-8, gauss-8, gauss-16 .*and not 'gauss-4'"):
            h.solve(h.variation(swung, T, h.gauss(4)), q0=1, v0=0)

    def test_verlet_on_fractions(self):
        times, F, step = [Fraction(0), Fraction(1, 3), Fraction(1, 2), Fraction(2)], lambda x: -x - x**3 / 3, Fraction(1, 10)
        L = h.Lagrangian(v**2 / 2 - q**2 / 2 - q**4 / 12, q, v)
        for T, steps in ((h.uniform(0, step, 4), [step] * 4), (h.TimeScale(times), [b - a for a, b in zip(times, times[1:])])):
            x = h.solve(h.variation(L, T, h.verlet), q0=Fraction(1, 2), v0=Fraction(1, 3))
            y, p = Fraction(1, 2), Fraction(1, 3)
            for i, t in enumerate(steps):  # half of a kick, a drift, half of a kick
                p += t / 2 * F(y)
                y += t * p
                p += t / 2 * F(y)
                self.assertEqual((x.q[i + 1], x.p[i + 1]), (y, p))
            self.assertEqual(x.residual(), 0)

    @unittest.skipIf(mpmath is None, "mpmath is not here")
    def test_compositions_in_fifty_digits(self):
        swung = h.Lagrangian(v**2 / 2 - (1 - h.cos(q)), q, v)
        with mpmath.workdps(50):
            end = lambda method, n: h.solve(h.variation(swung, h.uniform(mpmath.mpf(0), mpmath.mpf(1) / n, n), method), q0=1, v0=0).q[-1]
            best = end(h.gauss(8), 64)
            for method, order, n in ((h.verlet, 2, 64), (h.kahan_li_8, 8, 48)):
                a, b = abs(end(method, n) - best), abs(end(method, 2 * n) - best)
                self.assertAlmostEqual(float(mpmath.log(a / b, 2)), order, delta=0.02)

    def test_what_is_no_number(self):
        for x in (Decimal("NaN"), float("nan")):
            with self.assertRaisesRegex(h.NotFinite, "a number in a formula is finite"):
                q * x
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with self.assertRaises(TypeError):
                q * np.complex128(1 + 2j)
        self.assertEqual(repr(q * np.float32(0.5)), repr(q * 0.5))
        with self.assertRaisesRegex(h.InvalidParameter, "on a scale of fractions"):
            h.solve(h.variation(h.Lagrangian(v**2 / 2, q, v), h.uniform(0, Fraction(1, 10), 3)), q0=np.float32(0.1), v0=0)


class Failures(unittest.TestCase):
    def test_they_travel(self):
        wall = h.variation(h.Lagrangian("v^2/2 + log(1 - q)"), h.uniform(0, 0.1, 100))
        with self.assertRaises(h.StepFailure) as caught:
            h.solve(wall, q0=0.0, v0=30.0)
        for again in (pickle.loads(pickle.dumps(caught.exception)), copy.copy(caught.exception)):
            self.assertEqual(str(again), str(caught.exception))
            if caught.exception.solution is not None:
                np.testing.assert_array_equal(again.solution.q, caught.exception.solution.q)

    def test_an_interrupt_is_heard_between_slow_steps(self):
        # Numbers that grow: each step takes three times as long as the one before.
        slow = h.variation(h.Lagrangian("v^2/2 - q^4"), h.uniform(0, Fraction(1, 10), 40), h.order_one)
        threading.Timer(0.5, lambda: signal.raise_signal(signal.SIGINT)).start()
        with self.assertWarnsRegex(RuntimeWarning, "interrupted"):
            x = h.solve(slow, q0=1, v0=0)
        self.assertLess(len(x.q), 41)
        # What Python does not read or write at once is whole, and goes on.
        k = next(k for k, y in enumerate(x.q) if y.numerator > 10**4500)
        again = h.solve(h.variation(slow.lagrangian, h.uniform(0, Fraction(1, 10), 1), h.order_one), q0=x.q[k - 2], p0=x.p[k - 2])
        self.assertEqual(again.q[1], x.q[k - 1])
        self.assertEqual(again.q[0], x.q[k - 2])

    def test_sentences(self):
        L = oscillator.lagrangian
        for error, sentence, what in (
            (h.InvalidParameter, "the parameter k is a number or a list", lambda: h.Lagrangian("v^2/2 - k*q", k=None)),
            (TypeError, "an equation, as h.variation", lambda: h.solve_many(L, q0=[1.0], v0=0.0)),
            (TypeError, "a scale, as h.TimeScale", lambda: h.identities([0, 1])),
            (h.InvalidScale, "positive whole number", lambda: h.uniform(0, 0.1, 2**70)),
            (TypeError, "one at a time", lambda: h.variables("x", 3)[0:2]),
            (h.InvalidParameter, "an interval is two numbers", lambda: h.solve(L, 5, q0=1, v0=0, accuracy=1e-6)),
            (h.InvalidParameter, "an interval is two numbers", lambda: h.solve(L, "0..5", q0=1, v0=0, accuracy=1e-6)),
            (h.InvalidParameter, "the end of an interval is a real number", lambda: h.solve(L, (0, "x"), q0=1, v0=0, accuracy=1e-6)),
            (h.InvalidScale, "an interval ends after it begins, and this one goes from 5 to 0", lambda: h.solve(L, (5, 0), q0=1, v0=0, accuracy=1e-6)),
            (h.InvalidParameter, "an accuracy is a real number, and here is 'tight'", lambda: h.solve(L, (0, 5), q0=1, v0=0, accuracy="tight")),
            (h.NotFinite, "a number that double has", lambda: h.solve(oscillator, q0=10**400, v0=0)),
            (h.InvalidParameter, "a history is direct", lambda: h.solve(oscillator, q0=1, v0=0, history="nonsense")),
            (h.InvalidParameter, "a history is direct", lambda: h.solve_many(oscillator, q0=[1.0], v0=0, history="nonsense")),
            (h.InvalidParameter, "where there is fractional damping", lambda: h.solve(oscillator + h.damping(0.1, 0.5), q0=1, q1=1)),
        ):
            with self.assertRaises(error) as caught:
                what()
            self.assertIn(sentence, str(caught.exception))
        self.assertEqual(h.Lagrangian("v^2/2 - k*q", k=np.array(2.0)).dimension, 1)

    def test_division_by_zero(self):
        EL = h.variation(h.Lagrangian("v^2/2 - 1/q"), h.uniform(0, Fraction(1, 10), 2), h.order_one)
        with self.assertRaisesRegex(h.NotFinite, "a division by zero, for which there is no rational number"):
            h.solve(EL, q0=0, v0=0)

    def test_whole_numbers_of_numpy(self):
        large, L = 2**53 + 1, oscillator.lagrangian
        T = h.uniform(Fraction(0), np.int64(1), 2)
        for given in (large, np.int64(large), np.array([large])[0], np.uint64(large)):
            self.assertEqual(h.solve(h.variation(L, T), q0=given, v0=0).q[0], large)
            self.assertEqual(h.apply(h.identity, [given] * 3, h.TimeScale([Fraction(0), np.int64(1), 3]))[1][0], large)
        free = h.variation(h.Lagrangian("v^2/2 - k*q", k=np.int64(large)), T)
        self.assertEqual(free.lagrangian.dimension, 1)
        fall = h.variation(h.Lagrangian("v^2/2 - k*q", k=large), T)
        self.assertEqual(list(h.solve(free, q0=0, v0=0).q), list(h.solve(fall, q0=0, v0=0).q))

    def test_what_is_clear_is_taken(self):
        V = h.variables("v", 2)
        self.assertEqual(h.Lagrangian(np.array(V @ V / 2), "q[2]", "v[2]").dimension, 2)
        EL = h.variation(h.Lagrangian(V @ V / 2, "q[2]", "v[2]"), h.uniform(0, 0.5, 2))
        column = h.solve(EL + h.force(np.array([[1 - V[0]], [h.t]])), q0=[0, "1/2"], v0=[0, 0]).q
        np.testing.assert_array_equal(column, h.solve(EL + h.force(1 - V[0], h.t), q0=[0, 0.5], v0=[0, 0]).q)
        V += 1
        self.assertEqual(len(V), 2)
        x = h.solve(h.variation(oscillator.lagrangian, h.uniform(mpmath.mpf(0), mpmath.mpf("0.5"), 4)), q0=1, v0=0)
        self.assertEqual(x(Fraction(1, 4)), x("1/4"))
        for given in (0.25, mpmath.mpf("0.25")):
            self.assertAlmostEqual(x(given), x("0.25"), delta=1e-50)

    def test_what_is_no_number(self):
        x = h.solve(oscillator, q0=1, v0=0)
        exact = h.solve(h.variation(oscillator.lagrangian, h.uniform(0, Fraction(1, 2), 4)), q0=1, v0=0)
        for error, sentence, what in (
            (TypeError, "a number was expected, and here is array", lambda: h.TimeScale(np.array([[0, 1], [2, 3]])).kind()),
            (h.NotFinite, "the start of a scale is a number that double has", lambda: h.uniform(10**400, 1, 3)),
            (h.InvalidParameter, "the step of a scale is a real number", lambda: h.uniform(0, 0.1j, 3)),
            (h.InvalidParameter, "q0 is a real number, and here is None", lambda: h.solve(oscillator, q0=None, v0=1)),
            (h.InvalidParameter, "a time is a real number, and here is None", lambda: x(None)),
            (h.InvalidParameter, "a time on a scale of fractions", lambda: exact(0.3)),
            (h.InvalidParameter, "returns a real number, or a bool, and at t = 0.0 it is None", lambda: x.events(lambda t, q, p: None)),
            (h.InvalidParameter, "returns a real number, or a bool", lambda: x.events(lambda t, q, p: q + 0j)),
            (h.NotFinite, "is -inf at t = ", lambda: x.events(lambda t, q, p: np.float64(-np.inf) if t > 0.35 else 1.0)),
            (IndexError, "has the components 0 to 2, and here is 3", lambda: h.variables("x", 3)[3]),
            (TypeError, "f is a function of t", lambda: h.apply(h.sigma, h.sin(h.t), h.uniform(0, 0.1, 3))),
        ):
            with self.assertRaises(error) as caught:
                what()
            self.assertIn(sentence, str(caught.exception))


class Shown(unittest.TestCase):
    def test_all_of_the_equation(self):
        shown = (oscillator + h.force("-v/3") + h.damping(0.2, 0.5))._repr_latex_()
        for part in ("$\\displaystyle", "L = \\frac", "\\begin{aligned}", "\\frac{v}{3}", "-0.2 \\, D^{0.5} q"):
            self.assertIn(part, shown)
        of_verlet = h.variation(oscillator.lagrangian, oscillator.scale, h.verlet)
        self.assertIn("\\text{verlet", of_verlet._repr_latex_())
        self.assertIn("\nverlet\nbeside ∂L/∂q: -v", repr(of_verlet + h.force(-v)))

    def test_names(self):
        for name, shown in (
            ("omega_dot", "\\omega_{\\mathrm{dot}}"),
            ("theta", "\\theta"),
            ("q_1", "q_{1}"),
            ("q_a_b", "q_{\\mathrm{a\\_b}}"),
            ("q_", "\\mathrm{q\\_}"),
            ("angle", "\\mathrm{angle}"),
        ):
            self.assertIn(f"{{{shown}}}^{{2}}", h.Lagrangian(f"v^2/2 - {name}^2", name, "v")._repr_latex_())
        self.assertIn("{q_{1,0}}^{2}", h.Lagrangian("w[0]^2/2 - q_1[0]^2", "q_1[2]", "w[2]")._repr_latex_())


if __name__ == "__main__":
    unittest.main()
