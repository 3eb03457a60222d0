# SPDX-License-Identifier: BSL-1.0
"""Solutions to an accuracy: relative ones, and solutions between two ends, against closed forms."""

import pickle
import unittest

import hilger as h
import numpy as np

oscillator = h.Lagrangian("v^2/2 - q^2/2")
layers = h.Lagrangian("v^2/2 + 5000*q^2")  # q = cosh(100 (t - 1/2)) / cosh(50) between 1 and 1


class Relative(unittest.TestCase):
    def test_a_part_of_the_largest_position(self):
        x = h.solve(oscillator, (0, 200), q0=1000.0, v0=0.0, relative=1e-9)
        self.assertLess(np.abs(x.q - 1000 * np.cos(x.t)).max(), 1e-6)
        self.assertTrue(0 < x.error <= 1e-6)
        absolute = h.solve(oscillator, (0, 200), q0=1000.0, v0=0.0, accuracy=1e-9)
        self.assertLess(len(x), len(absolute))

    def test_both(self):
        x = h.solve(oscillator, (0, 200), q0=1000.0, v0=0.0, accuracy=1e-5, relative=1e-12)
        self.assertLess(np.abs(x.q - 1000 * np.cos(x.t)).max(), 1.1e-5)
        self.assertLess(len(x), len(h.solve(oscillator, (0, 200), q0=1000.0, v0=0.0, relative=1e-12)))

    def test_wrong_ones(self):
        for accuracies in ({"relative": -1e-6}, {"relative": 0}, {"relative": 1e-17}, {"relative": float("nan")}, {"relative": "tight"}):
            for other in ({"v0": 0.0}, {"qN": 0.5}):
                with self.assertRaisesRegex(h.InvalidParameter, "an accuracy"):
                    h.solve(oscillator, (0, 1), q0=1.0, **other, **accuracies)
        EL = h.variation(oscillator, h.uniform(0, 0.1, 10)) + h.damping(1.0, alpha=0.5)
        with self.assertRaisesRegex(h.InvalidParameter, "an accuracy go with a Lagrangian"):
            h.solve(EL, q0=1.0, v0=0.0, relative=1e-6)


class TwoEnds(unittest.TestCase):
    def test_an_oscillator(self):
        for accuracy in ({"accuracy": 1e-4}, {"accuracy": 1e-10}, {"relative": 1e-10}):
            x = h.solve(oscillator, (0, 1), q0=0.0, qN=np.sin(1), **accuracy)
            wanted = max(accuracy.values())
            self.assertLess(np.abs(x.q - np.sin(x.t)).max(), wanted)
            self.assertLess(np.abs(x.p - np.cos(x.t)).max(), 10 * wanted)
            self.assertTrue(0 <= x.error <= wanted)
            self.assertEqual((x.t[0], x.t[-1], x.q[0], x.q[-1]), (0, 1, 0, np.sin(1)))
            self.assertEqual(x.method, x.equation.method.name)
            self.assertLess(x.residual(), 64)
            self.assertLess(np.abs(x.energy() - 0.5).max(), 10 * wanted)
            self.assertLess(abs(x(0.3) - np.sin(0.3)), 10 * wanted)
            self.assertLess(abs(x.events(lambda t, q, p: q - 0.5).t[0] - np.pi / 6), 10 * wanted)
        again = pickle.loads(pickle.dumps(x))
        self.assertEqual((again.method, again.error, again.q.tolist()), (x.method, x.error, x.q.tolist()))

    def test_several_coordinates(self):
        plane = h.Lagrangian("dot(v, v)/2 - dot(q, q)/2", "q[2]", "v[2]")
        x = h.solve(plane, (0, 1), q0=[1.0, 0.0], qN=[np.cos(1), np.sin(1)], accuracy=1e-10)
        self.assertLess(np.abs(x.q - np.column_stack([np.cos(x.t), np.sin(x.t)])).max(), 1e-10)
        self.assertLess(np.abs(x.p - np.column_stack([-np.sin(x.t), np.cos(x.t)])).max(), 1e-9)

    def test_steps_are_short_in_boundary_layers(self):
        x = h.solve(layers, (0, 1), q0=1.0, qN=1.0, accuracy=1e-9)
        self.assertLess(np.abs(x.q - np.cosh(100 * (x.t - 0.5)) / np.cosh(50)).max(), 1e-9)
        steps = np.diff(x.t)
        self.assertLess(4 * steps[0], steps.max())
        self.assertLess(4 * steps[-1], steps.max())

    def test_the_longest_step(self):
        x = h.solve(oscillator, (0, 1), q0=0.0, qN=1.0, accuracy=1e-6, longest_step=1 / 128)
        self.assertLessEqual(np.diff(x.t).max(), 1 / 128)

    def test_what_else_is_given(self):
        def says(what, **given):
            with self.assertRaisesRegex(h.InvalidParameter, what):
                h.solve(oscillator, (0, 1), q0=1.0, accuracy=1e-6, **given)

        says("from v0 or to qN, and here are both", v0=0.0, qN=1.0)
        says("nothing else is given, or between q0 and qN", qN=1.0, guess=[1.0, 1.0])
        says("nothing else is given, or between q0 and qN", qN=1.0, p0=1.0)
        says("is solved over an interval to an accuracy")
        with self.assertRaisesRegex(h.Mismatch, "qN is one number, and here are 2"):
            h.solve(oscillator, (0, 1), q0=1.0, qN=[1.0, 2.0], accuracy=1e-6)
        with self.assertRaisesRegex(h.InvalidParameter, "an accuracy chooses its own steps in t"):
            h.solve(h.transform_time(oscillator, "1 + q^2"), (0, 1), q0=1.0, qN=0.5, accuracy=1e-6)
        EL = h.variation(oscillator, h.uniform(0, 0.1, 10)) + h.damping(1.0, alpha=0.5)
        with self.assertRaisesRegex(h.InvalidParameter, "go with a Lagrangian"):
            h.solve(EL, (0, 1), q0=1.0, qN=0.5, accuracy=1e-6)


class Steps(unittest.TestCase):
    def test_a_picture_of_them(self):
        try:
            import matplotlib  # noqa: F401
        except ImportError:
            self.skipTest("matplotlib is not installed")
        for x in (h.solve(layers, (0, 1), q0=1.0, qN=1.0, accuracy=1e-6), h.solve(h.variation(oscillator, h.uniform(0, 0.1, 5)), q0=1.0, v0=0.0)):
            line = x.plot_steps().lines[0]
            self.assertEqual(list(line.get_ydata()[::2]), list(np.diff(x.t)))
            self.assertEqual((list(line.get_xdata()[::2]), list(line.get_xdata()[1::2])), (list(x.t[:-1]), list(x.t[1:])))


if __name__ == "__main__":
    unittest.main()
