# SPDX-License-Identifier: BSL-1.0
"""Solutions against what is known of them: the equation is the judge."""

import pickle
import signal
import sys
import threading
import time
import unittest
import warnings
from fractions import Fraction

import numpy as np

import hilger as h

q, v = h.variables("q v")
pendulum = h.Lagrangian(v**2 / 2 - (1 - h.cos(q)), q, v)
oscillator = h.Lagrangian(v**2 / 2 - q**2 / 2, q, v)
every_method = [h.order_one, h.order_one_left, h.midpoint, h.theta(0.3), h.theta(Fraction(2, 3)), h.verlet, h.gauss(2), h.gauss(4), h.gauss(8), h.lobatto_3, h.kahan_li_8]
epsilon = np.finfo(float).eps


class Exact(unittest.TestCase):
    def test_rationals(self):
        h_ = Fraction(1, 10)
        x = h.solve(h.variation(oscillator, h.uniform(Fraction(0), h_, 20)), q0=1, v0=0)
        self.assertEqual(x.residual(), 0)
        self.assertTrue(all(H == Fraction(1, 2) for H in x.energy()))
        # q1 of the mid-point rule by hand: (4 - h^2)/(4 + h^2)
        self.assertEqual(x.q[1], (4 - h_**2) / (4 + h_**2))
        self.assertIsInstance(x.p[3], Fraction)
        self.assertEqual(x.t[20], 2)

    def test_methods_are_those_of_doubles(self):
        uneven = ["0", "1/3", "1", "7/5", "2"]
        for T, like in (
            (h.uniform(0, Fraction(1, 10), 20), h.uniform(0, 0.1, 20)),
            (h.TimeScale(uneven), h.TimeScale([float(Fraction(t)) for t in uneven])),
        ):
            for method in (h.order_one, h.order_one_left, h.midpoint, h.theta("1/3")):
                here, there = h.variation(oscillator, T, method), h.variation(oscillator, like, method)
                self.assertEqual(repr(here), repr(there))
                self.assertEqual(here._repr_latex_(), there._repr_latex_())
                x, y = (h.solve(EL, q0=1, v0=Fraction(1, 3)) for EL in (here, there))
                self.assertEqual(x.residual(), 0)
                for a, b in ((x.q, y.q), (x.p, y.p), (x.t, y.t)):
                    self.assertLess(np.abs(a.astype(float) - b).max(), 1e-14)
        own = h.embedding((2 * h.identity + h.sigma) / 3, h.Delta_plus)
        named, mine = (h.solve(h.variation(oscillator, h.TimeScale(uneven), m), q0=1, v0=0) for m in (h.theta(Fraction(1, 3)), own))
        self.assertEqual((list(named.q), list(named.p)), (list(mine.q), list(mine.p)))
        for wrong in (h.kahan_li_8, h.gauss(4)):
            with self.assertRaisesRegex(h.InvalidParameter, "in rationals the methods are order-one, order-one-left, mid-point, theta:0.3, verlet and"):
                h.solve(h.variation(oscillator, h.uniform(0, Fraction(1, 10), 3), wrong), q0=1, v0=0)
        with self.assertRaisesRegex(h.InvalidParameter, "theta takes a number between 0 and 1"):
            h.solve(h.variation(oscillator, h.uniform(0, Fraction(1, 10), 3), "theta:2"), q0=1, v0=0)

    def test_an_accuracy_holds_between_the_points_too(self):
        oscillator = h.Lagrangian(v**2 / 2 - q**2 / 2, q, v)
        t = np.linspace(0, 30, 301)
        for accuracy in (1e-3, 1e-6, 1e-9, 1e-12):
            x = h.solve(oscillator, (0, 30), q0=1.0, v0=0.0, accuracy=accuracy)
            self.assertLess(np.abs(x(t) - np.cos(t)).max(), accuracy)
            self.assertTrue(np.array_equal(x(x.t), x.q))
            zeros = x.events(lambda t, q, p: q)
            self.assertEqual(len(zeros.t), 10)
            self.assertLess(np.abs(zeros.t - np.pi * (np.arange(10) + 0.5)).max(), accuracy)
            self.assertLess(np.abs(np.abs(zeros.p) - 1).max(), accuracy)
            # in a step that has two
            near = x.events(lambda t, q, p: q + 0.9, "falling")
            self.assertEqual(len(near.t), 5)

    def test_what_is_no_number_is_no_larger_or_smaller_one(self):
        for f in ("max(0, sqrt(q))", "max(sqrt(q), 0)", "min(0, sqrt(q))", "min(sqrt(q), 0)"):
            EL = h.variation(h.Lagrangian("v^2/2"), h.uniform(0, 0.5, 1), h.order_one) + h.force(f)
            with self.assertRaisesRegex(h.StepFailure, "NaN"):
                h.solve(EL, q0=-1.0, v0=0.0)

    def test_energies_are_of_the_branches_of_the_steps(self):
        for threshold in ("7/20", "0.35", "7*0.05"):
            EL = h.variation(h.Lagrangian(f"if(t < {threshold}, 1, 3)*v^2/2"), h.uniform(0.35, 0.1, 2))
            x = h.solve(EL, q0=0.0, v0=1.0)
            self.assertTrue(np.array_equal(x.energy(), x.p**2 / (2 * np.where(x.t < eval(threshold), 1, 3))))

    def test_between_two_ends_against_a_force(self):
        for T in (h.uniform(0, Fraction(1, 4), 6), h.TimeScale(["0", "1/3", "1", "7/5", "2"])):
            for method in (h.order_one, h.midpoint):
                EL = h.variation(oscillator, T, method) + h.force(1 - v / 3 + h.t * q)
                x = h.solve(EL, q0=1, qN=Fraction(-1, 2))
                self.assertEqual((x.q[0], x.q[-1], x.residual()), (1, Fraction(-1, 2), 0))
                self.assertEqual(list(h.solve(EL, q0=1, q1=x.q[1]).q), list(x.q))

    def test_other_data(self):
        T = h.TimeScale(["0", "1/3", "1", "7/5", "2"])
        for method in (h.order_one, h.order_one_left, h.midpoint):
            EL = h.variation(oscillator, T, method)
            x = h.solve(EL, q0=Fraction(1, 2), v0=Fraction(1, 3))
            same = (h.solve(EL, q0=x.q[0], p0=x.p[0]), h.solve(EL, q0=x.q[0], q1=x.q[1]), h.solve(EL, q0=x.q[0], qN=x.q[-1]))
            for y in same:
                self.assertEqual(list(y.q), list(x.q))
                self.assertEqual(y.residual(), 0)

    def test_fractions_in_formulas_are_exact(self):
        L = h.Lagrangian(v**2 / 2 - Fraction(1, 3) * q**2, q, v)
        x = h.solve(h.variation(L, h.uniform(Fraction(0), Fraction(1), 2), h.order_one), q0=3, v0=0)
        self.assertEqual(x.q[1] - x.q[0], -2)  # p1 = p0 + h dL/dq(q0), q1 = q0 + h p1

    def test_identities(self):
        for T in (h.TimeScale(["0", "1/3", "1", "7/5"]), h.uniform(Fraction(1, 2), Fraction(2, 7), 5)):
            proved = h.identities(T)
            self.assertGreater(len(proved), 30)
            for identity in proved:
                self.assertTrue(identity.holds, identity.name)
                self.assertGreater(identity.equalities, 0)


class Events(unittest.TestCase):
    def test_between_the_points_a_solution_is_as_good_as_at_them(self):
        import mpmath

        with mpmath.workdps(60):  # the pendulum and Jacobi's elliptic functions
            k = mpmath.mpf(3) / 4
            exact = lambda t: 2 * mpmath.asin(k * mpmath.ellipfun("sn", t, m=k * k))
            for method, steps, bound in ((h.gauss(8), 200, "1e-32"), (h.kahan_li_8, 400, "1e-17")):
                x = h.solve(h.variation(pendulum, h.uniform(mpmath.mpf(0), mpmath.mpf(10) / steps, steps), method), q0=0, v0=2 * k)
                self.assertLess(abs(x.q[-1] - exact(mpmath.mpf(10))), mpmath.mpf(bound))
                for t in (mpmath.mpf(5) / 3, mpmath.mpf(20) / 3):
                    self.assertLess(abs(x(t) - exact(t)), mpmath.mpf(bound))
                turns = x.events(lambda t, q, p: p)
                self.assertEqual(len(turns.t), 3)
                for i, t in enumerate(turns.t):
                    self.assertLess(abs(t - (2 * i + 1) * mpmath.ellipk(k * k)), mpmath.mpf(bound))
                self.assertTrue(all(x(x.t[i]) == x.q[i] for i in (0, 7, steps)))

    def test_events_of_every_method_are_as_good_as_its_points(self):
        for method, order in ((h.midpoint, 2), (h.verlet, 2), (h.gauss(2), 4), (h.kahan_li_8, 8)):
            coarse, fine = (h.solve(h.variation(oscillator, h.uniform(0, 0.25 / n, 16 * n), method), q0=1.0, v0=0.0) for n in (1, 2))
            error = [abs(x.events(lambda t, q, p: q - 0.5).t[0] - np.pi / 3) for x in (coarse, fine)]
            self.assertAlmostEqual(np.log2(error[0] / error[1]), order, delta=0.15)

    def test_between_points_that_are_given_and_ends_that_are_joined(self):
        EL = h.variation(oscillator, h.TimeScale([0, 0.1, 0.4, 0.9, 1.5]), h.gauss(8))
        t = np.linspace(0, 1.5, 31)
        for x in (h.solve(EL, q0=1.0, v0=0.0), h.solve(EL, q0=1.0, qN=np.cos(1.5))):
            error = np.abs(x.q - np.cos(x.t)).max() + np.abs(x.p + np.sin(x.t)).max() + 8 * epsilon
            self.assertLess(error, 1e-12)
            self.assertLess(np.abs(x(t) - np.cos(t)).max(), error)
            self.assertLess(abs(x.events(lambda t, q, p: q - 0.5).t[0] - np.pi / 3), 2 * error)

    def test_a_contact_is_found_by_few_looks(self):
        L = h.Lagrangian(v**2 / 2 - h.where(q < 0, h.read("2/5") * (-q) ** h.read("5/2"), 0), q, v)
        x = h.solve(L, (0, 5), q0=0.5, v0=-1.0, accuracy=1e-12)
        looks = []
        found = x.events(lambda t, q, p: looks.append(t) or q)
        self.assertAlmostEqual(found.t[1] - found.t[0], 3.2180654597190431, delta=4e-12)  # two times, at a velocity of 1
        self.assertLess(len(looks), 4 * len(x) + 200)

    def test_digits(self):
        import mpmath

        with mpmath.workdps(60):
            x = h.solve(h.variation(oscillator, h.uniform(mpmath.mpf(0), mpmath.mpf(1) / 8, 64)), q0=1, v0=0)
        found = x.events(lambda t, q, p: q * q - q / 3)  # in 50 digits, whatever mpmath computes with elsewhere
        self.assertEqual(len(found.t), 6)
        self.assertTrue(all(min(abs(y), abs(y - 1 / mpmath.mpf(3))) < 1e-15 for y in found.q))
        with mpmath.workdps(60):
            self.assertTrue(all(abs(y * y - y / 3) < mpmath.mpf(10) ** -48 for y in found.q))

    def test_directions_ends_and_vectors(self):
        x = h.solve(h.variation(pendulum, h.uniform(0, 0.1, 200)), q0=1.0, v0=0.0)
        both, rising, falling = (x.events(lambda t, q, p: q, crossing) for crossing in ("any", "rising", "falling"))
        self.assertEqual(sorted([*rising.t, *falling.t]), both.t.tolist())
        self.assertTrue((rising.p > 0).all() and (falling.p < 0).all() and len(both.t) == 6)
        self.assertLess(np.abs(both.q).max(), 4 * 20 * epsilon)  # what t is rounded to, at a speed of 1
        for stays in (lambda t, q, p: max(0.5 - q, 0), lambda t, q, p: min(q - 0.5, 0)):  # its first zero is meant, and not the next point
            where = x.events(stays).t
            self.assertGreater(len(where), 0)
            crossing = "rising" if stays(0, 0.0, 0) < 0 else "falling"
            self.assertLess(np.abs(where - x.events(lambda t, q, p: q - 0.5 if crossing == "rising" else 0.5 - q, crossing).t).max(), 64 * epsilon)
        self.assertEqual(len(x.events(lambda t, q, p: p).t), 5)  # p = 0 at the start is none
        self.assertLess(np.abs(x.events(lambda t, q, p: t - 3.05).t - 3.05).max(), 4 * 3.05 * epsilon)
        none = x.events(lambda t, q, p: q - 2)
        self.assertEqual((none.t.shape, none.q.shape, none.p.shape), ((0,), (0,), (0,)))
        plane = h.Lagrangian("dot(v, v)/2 - dot(q, q)/2", "q[2]", "v[2]")
        y = h.solve(h.variation(plane, h.uniform(0, 0.1, 100), h.gauss(4)), q0=[1.0, 0.0], v0=[0.0, 1.0])
        found = y.events(lambda t, q, p: q[0] - q[1], "falling")
        self.assertEqual(found.q.shape, (2, 2))
        self.assertLess(np.abs(found.t - np.pi * np.array([0.25, 2.25])).max(), 1e-11)  # gauss(4) is of order 8

    def test_what_has_none(self):
        x = h.solve(h.variation(oscillator, h.uniform(0, Fraction(1, 10), 40)), q0=1, v0=0)
        with self.assertRaisesRegex(h.InvalidParameter, "root finding, which rationals have not"):
            x.events(lambda t, q, p: q)
        y = h.solve(h.variation(oscillator, h.uniform(0, 0.1, 40)), q0=1, v0=0)
        with self.assertRaisesRegex(h.InvalidParameter, 'is "any", "rising" or "falling"'):
            y.events(lambda t, q, p: q, "up")
        with self.assertRaisesRegex(h.NotFinite, "is nan at t = 0.0"):
            y.events(lambda t, q, p: float("nan"))
        with self.assertRaisesRegex(ZeroDivisionError, "division"):
            y.events(lambda t, q, p: q + 1 // int(t < 2))
        with self.assertRaisesRegex(TypeError, "positional argument"):
            y.events(lambda q: q)


class Double(unittest.TestCase):
    def test_orders(self):
        order = {"theta:0.3": 1, "theta:2/3": 1, "order-one": 1, "order-one-left": 1, "mid-point": 2, "verlet": 2, "gauss-2": 4, "lobatto-3": 4}
        best = h.solve(h.variation(pendulum, h.uniform(0, 0.05, 20), h.gauss(8)), q0=1.0, v0=0.5).q[-1]
        for method in every_method:
            if method.name in order:
                errors = [h.solve(h.variation(pendulum, h.uniform(0, 1 / n, n), method), q0=1.0, v0=0.5).q[-1] - best for n in (80, 160)]
                self.assertAlmostEqual(np.log2(errors[0] / errors[1]), order[method.name], delta=0.05, msg=method.name)

    def test_equations_hold(self):
        for method in every_method:
            x = h.solve(h.variation(pendulum, h.uniform(0, 0.125, 100), method), q0=1.0, v0=0.5)
            self.assertEqual(len(x), 101)
            # values at equidistant points inside a step are known from the polynomial through them, to 2^degree roundings
            degree = int(method.name[-1]) if method.name.startswith(("gauss", "lobatto")) else 0
            parts = 16 if method is h.kahan_li_8 else 1  # the shortest part of a composition is as many times shorter than its step
            self.assertLess(x.residual(), 64, method.name)

    def test_long_steps_are_judged_by_what_they_did_inside(self):
        two_wells = h.Lagrangian("v^2/2 - 50*(q^2 - 1)^2")
        for method, step, q0, v0 in ((h.gauss(2), 0.177, 0.18, -0.42), (h.lobatto_3, 0.1, -0.314144, -2.06111)):
            x = h.solve(h.variation(two_wells, h.uniform(0, step, 20), method), q0=q0, v0=v0)
            # rows at the points inside, 2 a step at most; between the ends there are other points, which leave 100 and more
            self.assertLess(x.residual(), 64, method.name)

    def test_compositions_are_judged_by_positions_and_momenta(self):
        swing = h.Lagrangian("m*v^2/2 - k*q^4/4", m=2, k="1/3")
        plane = h.Lagrangian("dot(v, v)/2 - q[0]^2*q[1]^2/2 + q[0]*v[1]", "q[2]", "v[2]")  # no kicks and drifts
        driven = h.variation(pendulum, h.TimeScale(np.cumsum([0.0, 0.1, 0.05, 0.2, 0.1])), h.verlet) + h.force("cos(t) - v/5")
        for EL, start, step, parts in (
            (h.variation(swing, h.uniform(0, 0.1, 100), h.kahan_li_8), {"q0": 1.0, "v0": 0.5}, 0.1, 16),
            (h.variation(plane, h.uniform(0, 0.1, 100), h.verlet), {"q0": [1.0, 0.5], "v0": [0.0, -1.0]}, 0.1, 2),
            (driven, {"q0": 1.0, "v0": 0.5}, 0.05, 2),
        ):
            x = h.solve(EL, **start)
            self.assertLess(x.residual(), 64)  # by the length of the shortest part
            for moved in (x.q, x.p):
                was = moved[2].copy()
                moved[2] += 1e-6
                self.assertGreater(x.residual(), 1e6)
                moved[2] = was

    def test_theta_one_half_is_the_mid_point(self):
        T = h.uniform(0, 0.125, 50)
        x, y = (h.solve(h.variation(pendulum, T, method), q0=1.0, v0=0.5) for method in (h.midpoint, h.theta(0.5)))
        np.testing.assert_allclose(x.q, y.q, rtol=0, atol=8 * epsilon * T.steps)  # few coordinates have an engine of their own

    def test_two_sided(self):
        T = h.uniform(0, 1 / 64, 64)
        EL = h.variation(h.Lagrangian("v^2/2 - q"), T, h.two_sided(0.75))
        x = h.solve(EL, q0=0.0, qN=1.0)
        self.assertEqual((x.q[0], x.q[-1]), (0, 1))
        self.assertLess(x.residual(), 64)
        self.assertIn("Δ₊^(0.75)[∂L/∂v(⋆)]", repr(EL))
        self.assertRaisesRegex(h.InvalidParameter, "looks to both ends", lambda: h.solve(EL, q0=0.0, v0=1.0))
        # of order 1 it is the equation of order one
        same = h.variation(h.Lagrangian("v^2/2 - q"), T, h.two_sided(1)), h.variation(h.Lagrangian("v^2/2 - q"), T, h.order_one_left)
        a, b = (h.solve(how, q0=0.0, qN=1.0).q for how in same)
        self.assertLess(np.abs(a - b).max(), 1e-11)

    def test_friction_is_damping_of_order_one(self):
        EL = h.variation(pendulum, h.uniform(0, 0.1, 500))
        x = h.solve(EL + h.damping(0.2, alpha=1.0), q0=1.0, v0=0.3, history=h.direct())
        y = h.solve(EL + h.force(-0.2 * v), q0=1.0, v0=0.3)
        self.assertLess(np.abs(x.q - y.q).max(), 500 * 16 * epsilon)

    def test_histories_agree(self):
        EL = h.variation(pendulum, h.uniform(0, 0.05, 1000)) + h.damping(0.2, 0.5) + h.damping(0.05, 1.25)
        by_sum = h.solve(EL, q0=1.0, v0=0.3, history=h.direct())
        self.assertLess(by_sum.residual(), 64)
        for history in (h.blocks(), h.exponentials()):
            self.assertLess(np.abs(h.solve(EL, q0=1.0, v0=0.3, history=history).q - by_sum.q).max(), 1e-12)
        self.assertLess(np.abs(h.solve(EL, q0=1.0, v0=0.3, history=h.exponentials(1e-6)).q - by_sum.q).max(), 1e-4)

    def test_vectors(self):
        x, u = h.variables("x u", 2)
        kepler = h.Lagrangian(h.dot(u, u) / 2 + 1 / h.norm(x), x, u)
        text = h.Lagrangian("dot(u, u)/2 + k/norm(x)", "x[2]", "u[2]", k=1)
        two = h.Lagrangian("(a^2 + b^2)/2 + 1/hypot(x, y)", h.variables("x y"), h.variables("a b"))
        solutions = []
        for L in (kepler, text, two):
            s = h.solve(h.variation(L, h.uniform(0, 0.05, 200), h.gauss(4)), q0=[0.4, 0], v0=[0, 2])
            self.assertEqual(s.q.shape, (201, 2))
            self.assertLess(np.abs(s.energy() + 0.5).max(), 1e-7)
            solutions.append(s.q)
        self.assertLess(np.abs(solutions[0] - solutions[1]).max(), 1e-12)
        self.assertLess(np.abs(solutions[0] - solutions[2]).max(), 1e-12)

    def test_between_the_points(self):
        coarse = h.solve(h.variation(pendulum, h.uniform(0, 0.1, 50), h.gauss(4)), q0=1.0, v0=0.5)
        fine = h.solve(h.variation(pendulum, h.uniform(0, 0.05, 100), h.gauss(4)), q0=1.0, v0=0.5)
        self.assertLess(np.abs(coarse(fine.t) - fine.q).max(), 1e-6)
        self.assertEqual(coarse(0.0), 1.0)
        self.assertEqual(coarse(coarse.t[-1]), coarse.q[-1])

    def test_what_joins_two_ends_is_the_motion_of_its_first_state(self):
        forced = h.variation(pendulum, h.TimeScale(np.cumsum([0.0, 0.1, 0.05, 0.2, 0.1]))) + h.force("cos(t) - v/5")
        swing = h.Lagrangian("m*v^2/2 - k*q^4/4", m=2, k="1/3")
        parts = h.variation(h.Lagrangian("v^2/2"), h.uniform(0, 0.1, 10)) + h.variation(h.Lagrangian("-q^4/4"), h.uniform(0, 0.1, 10), h.order_one)
        for EL in (forced, h.variation(swing, h.uniform(0, 0.1, 10), h.lobatto_3), h.variation(swing, h.uniform(0, 0.1, 10), h.gauss(4)), parts):
            x = h.solve(EL, q0=0.25, qN=0.5)
            y = h.solve(EL, q0=0.25, p0=x.p[0])
            self.assertLess(np.abs(x.q - y.q).max(), 1e-12)
            self.assertLess(np.abs(x.p - y.p).max(), 1e-11)
            self.assertAlmostEqual(x(0.3), y(0.3), delta=1e-12)
            self.assertLess(x.residual(), 64)
            x.q[3] += 1e-3
            self.assertGreater(x.residual(), 1e6)  # of the positions that there are
        exact = h.variation(h.Lagrangian("v^2/2 - q^2/2"), h.uniform(0, Fraction(1, 10), 10), h.theta(Fraction(1, 3)))
        x = h.solve(exact, q0=1, qN=Fraction(1, 2))
        self.assertEqual(list(h.solve(exact, q0=1, p0=x.p[0]).p), list(x.p))

    def test_what_joins_two_ends_in_long_steps_is_judged_by_what_it_does_inside(self):
        two_wells = h.Lagrangian("v^2/2 - 50*(q^2 - 1)^2")
        x = h.solve(h.variation(two_wells, h.uniform(0, 0.177, 10), h.gauss(2)), q0=-0.7439458242004173, qN=0.9324690236313515)
        self.assertLess(x.residual(), 64)

    def test_a_two_sided_equation_has_no_momenta(self):
        x = h.solve(h.variation(h.Lagrangian("v^2/2"), h.uniform(0, 0.1, 10), h.two_sided(0.75)), q0=0.0, qN=0.5)
        self.assertIsNone(x.p)
        self.assertRaisesRegex(h.InvalidParameter, "positions alone", x.energy)
        self.assertRaisesRegex(h.InvalidParameter, "positions alone", lambda: x(0.5))

    def test_of_several_solutions_the_one_near_a_guess(self):
        EL = h.variation(pendulum, h.uniform(0, 0.1, 100))
        swinging = h.solve(EL, q0=1.0, v0=0.0)
        near = h.solve(EL, q0=1.0, qN=swinging.q[-1], guess=1.05 * np.cos(0.95 * swinging.t))
        self.assertLess(np.abs(near.q - swinging.q).max(), 1e-11)
        thrown = h.solve(EL, q0=1.0, qN=swinging.q[-1], guess=2 * np.sin(0.5 * swinging.t))
        self.assertGreater(np.abs(thrown.q - swinging.q).max(), 1)
        self.assertLess(thrown.residual(), 64)
        far = h.solve(EL, q0=1.0, qN=-0.5)  # whole corrections lead away from the straight line
        self.assertLess(far.residual(), 64)
        exact = h.variation(oscillator, h.uniform(0, Fraction(1, 10), 3))
        self.assertEqual(list(h.solve(exact, q0=1, qN=0, guess=[1, 5, 7, 0]).q), list(h.solve(exact, q0=1, qN=0).q))
        with self.assertRaisesRegex(h.Mismatch, "a row for each of the 101 points of T, and here are 2"):
            h.solve(EL, q0=1.0, qN=0.5, guess=[1.0, 0.5])
        with self.assertRaisesRegex(h.InvalidParameter, "a guess is for what joins two ends"):
            h.solve(EL, q0=1.0, v0=0.5, guess=swinging.q)

    def test_accuracy_where_first_steps_lead_too_far(self):
        # Morse's oscillator from rest: exp(q) = (1 - s cos(w t)) / (1 - s^2)
        morse = h.Lagrangian("v^2/2 - (exp(-2*q) - 2*exp(-q))")
        E = np.exp(0.6) - 2 * np.exp(0.3)
        x = h.solve(morse, (0, 100), q0=-0.3, v0=0, accuracy=1e-9)
        self.assertLess(np.abs(x.q - np.log((1 - np.sqrt(1 + E) * np.cos(np.sqrt(-2 * E) * x.t)) / -E)).max(), 1e-9)
        with self.assertRaisesRegex(h.NotFinite, r"the step from t = [\d.e-]+ with"):
            h.solve(h.Lagrangian("v^2/2 + q*sqrt(1 - q)"), (0, 1), q0=1.0 - 1e-9, v0=4, accuracy=1e-9)

    def test_accuracy_over_a_long_time(self):
        # steps of some time units, which all fail near the start, are too long, and no end of the motion
        pendulum = h.Lagrangian("v^2/2 + cos(q)")
        x = h.solve(pendulum, (0, 1e5), q0=1, v0=0, accuracy=1e-6)
        self.assertLess(np.abs(x.energy() + np.cos(1)).max(), 1e-5)
        self.assertEqual(x.t[-1], 1e5)

    def test_accuracy(self):
        exact = h.solve(oscillator, (0, 10), q0=1.0, v0=0.0, accuracy=1e-10)
        self.assertLess(np.abs(exact.p + np.sin(exact.t)).max(), 1e-9)
        plane = h.solve(h.Lagrangian("dot(v, v)/2 - dot(q, q)/2", "q[2]", "v[2]"), (0, 10), q0=[1.0, 0.0], v0=[0.0, 1.0], accuracy=1e-10)
        self.assertLess(np.abs(plane.p - np.column_stack([-np.sin(plane.t), np.cos(plane.t)])).max(), 1e-9)
        self.assertLess(np.abs(exact.q - np.cos(exact.t)).max(), 1e-10)
        # it is a solution as others are, of the equation that was chosen
        self.assertEqual(len(exact), len(exact.t))
        self.assertEqual(exact.equation.method.name, exact.method)
        self.assertLess(np.abs(exact.energy() - 0.5).max(), 1e-10)
        self.assertLess(exact.residual(), 64)  # of polynomials of degree 8 in each step
        self.assertLess(abs(exact(1.25) - np.cos(1.25)), 1e-10)
        self.assertLess(np.abs(exact.events(lambda t, q, p: q).t - np.pi * np.array([0.5, 1.5, 2.5])).max(), 1e-10)
        again = pickle.loads(pickle.dumps(exact))
        self.assertEqual((again.method, again.error, again.t.tolist()), (exact.method, exact.error, exact.t.tolist()))

    def test_the_residual_of_what_has_stopped(self):
        for T in (h.uniform(0, 0.125, 100), h.TimeScale([0.125 * i for i in range(101)])):
            whole = h.solve(h.variation(oscillator, T), q0=1.0, v0=0.0)
            part = h.solve(h.variation(oscillator, T), q0=1.0, v0=0.0, until=lambda t, q, p: q)
            self.assertLess(len(part), 20)
            self.assertLess(part.residual(), 64)
            part.q[3] += 1e-3  # which a residual sees
            self.assertGreater(part.residual(), 1e6)
            self.assertEqual(whole.q[len(part) - 1], part.q[-1])
        with self.assertRaises(h.StepFailure) as failed:
            h.solve(h.variation(h.Lagrangian("v^2/2 + q^4"), h.uniform(0, 0.01, 1000)), q0=1.0, v0=1.0)
        reached = failed.exception.solution
        self.assertLess(reached.residual(), 64)

    def test_many_digits(self):
        try:
            import mpmath
        except ImportError:
            self.skipTest("mpmath is not installed")
        with mpmath.workdps(50):
            T = h.uniform(mpmath.mpf(0), mpmath.mpf(1) / 10, 10)
            x = h.solve(h.variation(oscillator, T), q0=1, v0=0)
            exact = h.solve(h.variation(oscillator, h.uniform(Fraction(0), Fraction(1, 10), 10)), q0=1, v0=0).q[-1]
            self.assertLess(abs(x.q[-1] - mpmath.mpf(exact.numerator) / exact.denominator), mpmath.mpf(10) ** -48)


class Arrays(unittest.TestCase):
    def test_no_copies(self):
        x = h.solve(h.variation(pendulum, h.uniform(0, 0.1, 1000)), q0=1.0, v0=0.0)
        self.assertEqual(x.q.shape, (1001,))
        for array in (x.t, x.q, x.p):
            self.assertEqual(array.dtype, np.float64)
            self.assertFalse(array.flags.owndata)
        kept = x.q
        del x
        self.assertEqual(kept[0], 1.0)

    def test_numbers_of_numpy(self):
        EL = h.variation(h.Lagrangian(v**2 / 2 - np.float64(0.5) * q**2, q, v), h.uniform(np.float64(0), np.float32(0.125), 8))
        self.assertEqual(h.solve(EL, q0=np.int64(1), v0=np.float32(0)).q[0], 1)


class Pictures(unittest.TestCase):
    def test_axes(self):
        try:
            import matplotlib  # noqa: F401
        except ImportError:
            self.skipTest("matplotlib is not installed")
        x = h.solve(h.variation(pendulum, h.uniform(0, 0.1, 100)), q0=1.0, v0=0.0)
        self.assertEqual(list(x.plot().lines[0].get_ydata()), list(x.q))
        self.assertEqual(x.plot_energy_error().lines[0].get_ydata()[0], 0)


class Endings(unittest.TestCase):
    runs_away = h.Lagrangian(v**2 / 2 + q**4, q, v)

    def test_what_was_reached_is_kept(self):
        with self.assertRaises(h.StepFailure) as caught:
            h.solve(h.variation(self.runs_away, h.uniform(0, 0.1, 100)), q0=1.0, v0=0.0)
        x = caught.exception.solution
        self.assertGreater(len(x), 3)
        self.assertIn("the step from t = ", x.stopped)
        self.assertLess(x.residual(), 64)
        self.assertEqual(x(x.t[-1]), x.q[-1])
        self.assertTrue(np.all(np.isfinite(x.q)))

    def test_an_accuracy_is_given_up_on_an_interrupt(self):
        kink = h.Lagrangian("v^2/2 - abs(q)")
        timer = threading.Timer(0.3, lambda: signal.raise_signal(signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            h.solve(kink, (0, 1000), q0=1.0, v0=0.0, accuracy=1e-12)
        timer.join()

    def test_a_solution_between_two_ends_is_given_up_on_an_interrupt(self):
        EL = h.variation(pendulum, h.uniform(0, 1e-6, 2_000_000), h.midpoint)  # many seconds
        timer = threading.Timer(0.3, lambda: signal.raise_signal(signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            h.solve(EL, q0=1.0, qN=0.5)
        timer.join()

    def test_a_walk_ends_where_a_function_passes_zero(self):
        EL = h.variation(h.Lagrangian(v**2 / 2 - q, q, v), h.uniform(0, 0.125, 100), h.midpoint)
        height = lambda t, q, p: q
        x, whole = (h.solve(EL, q0=1.0, v0=0.0, until=g) for g in (height, None))
        self.assertEqual(x.t[-1], 1.5)  # the first point behind sqrt 2
        self.assertEqual(list(x.q), list(whole.q[: len(x)]))
        self.assertIn("passed zero by t = 1.5", x.stopped)
        found = x.events(height)
        self.assertEqual(len(found.t), 1)
        self.assertAlmostEqual(found.t[0], 2**0.5, delta=4 * epsilon)
        self.assertIsNone(h.solve(EL, q0=1.0, v0=0.0, until=lambda t, q, p: q + 1000).stopped)
        self.assertEqual(h.solve(EL, q0=0.0, v0=1.0, until=height).t[-1], 2.0)  # and not at the start, nor behind the end of its flight
        self.assertEqual(h.solve(EL, q0=1.0, v0=0.0, until=lambda t, q, p: q > 0).t[-1], 1.5)
        self.assertEqual(h.solve(EL, q0=1.0, v0=0.0, until=lambda t, q, p: -q).t[-1], 1.5)  # rising

        exact = h.variation(h.Lagrangian(v**2 / 2 - q, q, v), h.uniform(0, Fraction(1, 8), 100), h.midpoint)
        self.assertEqual(h.solve(exact, q0=Fraction(1), v0=Fraction(0), until=height).t[-1], Fraction(3, 2))
        with_memory = h.solve(EL + h.damping(1.0, alpha=0.5), q0=1.0, v0=0.0, until=height)
        self.assertGreater(with_memory.t[-1], 1.5)
        self.assertLessEqual(with_memory.q[-1], 0)
        plane = h.variation(h.Lagrangian("dot(v, v)/2 - q[1]", "q[2]", "v[2]"), h.uniform(0, 0.125, 100), h.midpoint)
        self.assertEqual(h.solve(plane, q0=[0.0, 1.0], v0=[1.0, 0.0], until=lambda t, q, p: q[1]).q[-1][0], 1.5)

        def breaks(t, q, p):
            raise ValueError("of its own")

        self.assertRaisesRegex(ValueError, "of its own", h.solve, EL, q0=1.0, v0=0.0, until=breaks)
        for wrong in ({"v0": 0.0, "until": 3}, {"qN": 0.0, "until": height}, {"v0": 0.0, "until": height, "compiled": True}):
            self.assertRaisesRegex(h.InvalidParameter, "until", h.solve, EL, q0=1.0, **wrong)

    def test_the_start_alone(self):
        wall = h.Lagrangian("v^2/2 - sqrt(1 - q)")  # which draws: no middle before it solves the step
        with self.assertRaises(h.StepFailure) as failed:
            h.solve(h.variation(wall, h.uniform(0, 1.0, 5)), q0=0.5, v0=10.0)
        x = failed.exception.solution
        self.assertEqual((len(x), x(0.0)), (1, 0.5))

    def test_an_interrupt_keeps_what_there_is(self):
        EL = h.variation(pendulum, h.uniform(0, 0.01, 50_000_000))
        timer = threading.Timer(0.3, lambda: signal.raise_signal(signal.SIGINT))
        timer.start()
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            x = h.solve(EL, q0=1.0, v0=0.0)
        self.assertLess(len(x), 50_000_000)
        self.assertIn("interrupted", x.stopped)
        self.assertEqual([w.category for w in said], [RuntimeWarning])

    def test_progress(self):
        seen = []
        h.solve(h.variation(pendulum, h.uniform(0, 0.01, 1000)), q0=1.0, v0=0.0, progress=seen.append)
        self.assertEqual((seen[-1], seen), (1000, sorted(seen)))

        def enough(steps):
            seen.append(steps)
            if len(seen) == 3:
                signal.raise_signal(signal.SIGINT)

        endless, seen = h.variation(pendulum, h.uniform(0, 0.01, 50_000_000)), []
        with warnings.catch_warnings(record=True):
            warnings.simplefilter("always")
            x = h.solve(endless, q0=1.0, v0=0.0, progress=enough)  # Ctrl-C while a bar is drawn
        self.assertEqual((len(x), len(seen), seen), (seen[2] + 1, 3, sorted(seen)))
        self.assertIn("interrupted", x.stopped)

        def heard_there(t, q, p):
            if t > 0.995:
                signal.raise_signal(signal.SIGINT)
            return 1.0

        with warnings.catch_warnings(record=True):
            warnings.simplefilter("always")
            x = h.solve(endless, q0=1.0, v0=0.0, until=heard_there)
        self.assertEqual((len(x), "interrupted" in x.stopped), (101, True))
        self.assertRaisesRegex(h.InvalidParameter, "progress is True, for a bar, or a function", h.solve, endless, q0=1.0, v0=0.0, progress="yes")

        def broken(_):
            raise LookupError("no bar")

        with self.assertRaisesRegex(LookupError, "no bar"):
            h.solve(endless, q0=1.0, v0=0.0, progress=broken)

    def test_others_run_meanwhile(self):
        # No thread is asked to give way, so another one counts on between two points of a solution only where solve lets it.
        counted, seen, ended = [0], [], threading.Event()

        def count():
            while not ended.is_set():
                counted[0] += 1
                time.sleep(0)

        def has_counted(t, q, p):
            seen.append(counted[0])
            return seen[-1] > seen[0]

        other, interval = threading.Thread(target=count), sys.getswitchinterval()
        sys.setswitchinterval(3600)
        try:
            other.start()
            h.solve(h.variation(pendulum, h.uniform(0, 0.01, 1_000_000), h.gauss(4)), q0=1.0, v0=0.0, until=has_counted)
        finally:
            ended.set()
            sys.setswitchinterval(interval)
            other.join()
        self.assertGreater(seen[-1], seen[0])


if __name__ == "__main__":
    unittest.main()
