# SPDX-License-Identifier: BSL-1.0
"""Formulas print as the text that is read again; whatever was stated or solved can be copied and kept."""

import copy
import pickle
import unittest
from fractions import Fraction

import numpy as np

import hilger as h

q, v = h.variables("q v")
pendulum = h.Lagrangian("v^2/2 - g*(1 - cos(q))", g=9.81)


class Printed(unittest.TestCase):
    def test_formulas(self):
        x = h.Vector("x", 3)
        for formula, text in (
            (v**2 / 2 - (1 - h.cos(q)), "v^2/2 - (1 - cos(q))"),
            (Fraction(1, 3) * x[0] ** 2 - 0.1 * abs(x[2]), "1/3*x[0]^2 - 0.1*abs(x[2])"),
            (-2 * q, "-2*q"),
            (h.where((q < 1) & ~(v >= 2) | (q > 3), q, -q), "if(q < 1 and not 2 <= v or 3 < q, q, -q)"),
        ):
            self.assertEqual(repr(formula), text)
            self.assertEqual(repr(h.read(text)), text)
        long = q
        for _ in range(100):
            long = long * long
        self.assertIn("more than", repr(long))

    def test_equations(self):
        EL = h.variation(pendulum, h.uniform(0, 0.1, 10)) + h.force(-v / 10 + h.sin(h.t)) + h.damping(0.2, 0.5)
        self.assertIn("beside ∂L/∂q: -v/10 + sin(t)\n", repr(EL))
        self.assertIn("beside ∂L/∂q: −0.2 D^0.5 q\n", repr(EL))

    def test_conditions(self):
        T = h.uniform(Fraction(0), Fraction(1, 4), 8)
        L = h.Lagrangian(v**2 / 2 - h.where((q < 1) & (h.t < 100), q, 3 * q), q, v)
        text = h.Lagrangian("v^2/2 - if(q < 1 and t < 100, q, 3*q)")
        x, y = (h.solve(h.variation(of, T), q0=Fraction(1, 2), v0=2) for of in (L, text))
        self.assertEqual(list(x.q), list(y.q))
        with self.assertRaisesRegex(TypeError, "here is a bool: conditions are made by <, <="):
            h.where(q == 1, q, v)
        with self.assertRaisesRegex(h.InvalidParameter, "asks a comparison, as q > 1, .* and here is q$"):
            h.where(q, 1, 2)


class Kept(unittest.TestCase):
    def again(self, what):
        return pickle.loads(pickle.dumps(what))

    def test_what_was_shared_is_shared(self):
        long = q
        for _ in range(60):
            long = long / (1 + long * long)  # 3^60 names when written out
        one, two = (h.solve(h.variation(h.Lagrangian(v**2 / 2 + of, q, v), h.uniform(0, 0.125, 8)), q0=1, v0=0) for of in (long, self.again(long)))
        self.assertEqual(one.q.tolist(), two.q.tolist())
        chain = sum((q for _ in range(20_000)), start=v)
        self.assertEqual(repr(self.again(chain))[:40], repr(chain)[:40])

    def test_problems_and_solutions(self):
        exact = h.Lagrangian("m*v^2/2 - k*q^2/2", m="3/2", k=1)
        triple = h.Lagrangian("dot(v, v)/2 - w[0]*q[0]^2 - q[1]*q[2]", "q[3]", "v[3]", w=[0.5])
        for EL, start in (
            (h.variation(pendulum, h.uniform(0, 0.1, 50), h.verlet), {"q0": 1.0, "v0": 0.0}),
            (h.variation(pendulum, h.uniform(0, 0.1, 50)) + h.force(-v / 10) + h.damping(0.2, 0.5), {"q0": 1.0, "v0": 0.0}),
            (h.variation(exact, h.TimeScale(["0", "1/3", "1"])), {"q0": 1, "v0": Fraction(1, 7)}),
            (h.variation(triple, h.uniform(0, 0.1, 50), h.gauss(2)), {"q0": [1.0, 0.0, 0.5], "p0": [0.0, 1.0, 0.0]}),
        ):
            x = h.solve(EL, **start)
            x.residual()  # makes what is not kept
            for EL2, x2 in ((self.again(EL), self.again(x)), (copy.deepcopy(EL), copy.deepcopy(x))):
                self.assertEqual(repr(EL2), repr(EL))
                self.assertEqual(np.asarray(x2.q).tolist(), np.asarray(x.q).tolist())
                self.assertEqual(np.asarray(h.solve(EL2, **start).p).tolist(), np.asarray(x.p).tolist())
                self.assertEqual(repr(x2), repr(x))

    def test_equality(self):
        def made(of, **changed):
            L = h.Lagrangian(of, **{"m": "3/2", "k": [1], **changed})
            return h.variation(L, h.TimeScale(["0", "1/3", "1"]), h.order_one) + h.force("-v")

        of_list = "m*v^2/2 - k[0]*q^2/2"
        EL = made(of_list)
        self.assertEqual((self.again(EL), hash(self.again(EL))), (EL, hash(EL)))
        self.assertEqual(made(of_list), EL)
        for other in (made(of_list, m=2), made(of_list, k=[2]), made(of_list + " + q*t"), EL + h.force("-v"), EL.lagrangian, None):
            self.assertNotEqual(other, EL)
        self.assertNotEqual(h.TimeScale([0, 1]), h.TimeScale([0, 2]))
        for one, same in (
            (h.TimeScale(["0", "1/3"]), h.TimeScale([Fraction(0), Fraction(2, 6)])),
            (h.uniform(0, "1/10", 3), h.uniform(Fraction(0), Fraction(1, 10), 3)),
        ):
            self.assertEqual(one, same)
            self.assertEqual(hash(one), hash(same))
        self.assertNotEqual(h.uniform(0, "1/10", 3), h.uniform(0, 0.1, 3))
        with self.assertRaisesRegex(TypeError, "a set has no first"):
            h.TimeScale({0, 1})
        long = h.TimeScale(range(10_000))
        self.assertEqual(repr(long), "<TimeScale of 10000 points, 0, 1, 2 ... 9999>")

    def test_going_on(self):
        whole = h.solve(h.variation(pendulum, h.uniform(0.0, 0.125, 40)), q0=1.0, v0=0.0)
        first = self.again(h.solve(h.variation(pendulum, h.uniform(0.0, 0.125, 16)), q0=1.0, v0=0.0))
        later = h.solve(h.variation(pendulum, h.uniform(2.0, 0.125, 24)), q0=first.q[-1], p0=first.p[-1])
        self.assertEqual(later.t.tolist(), whole.t[16:].tolist())
        self.assertLess(np.abs(later.q - whole.q[16:]).max(), 40 * 64 * np.finfo(float).eps)

    def test_a_parameter_may_be_called_L(self):
        coil = h.Lagrangian("L*v^2/2 - q^2/(2*C)", L=2.0, C=0.5)
        same = h.Lagrangian("v^2 - q^2")
        T = h.uniform(0, 0.125, 20)
        self.assertEqual(*(h.solve(h.variation(of, T), q0=1.0, v0=0.0).q.tolist() for of in (coil, same)))


if __name__ == "__main__":
    unittest.main()
