# SPDX-License-Identifier: BSL-1.0
"""What is written wrongly is said in one sentence; what is clear is taken."""

import contextlib
import io
import unittest
from decimal import Decimal
from fractions import Fraction

import numpy as np

import hilger as h

q, v = h.variables("q v")
L = h.Lagrangian(v**2 / 2 - q**2 / 2, q, v)
T = h.uniform(0, 0.1, 10)
EL = h.variation(L, T)


class OfNumpyAndMpmath(unittest.TestCase):
    def test_arithmetic_of_vectors(self):
        x, u = h.variables("x u", 2)
        V = h.Lagrangian(h.dot(u, u) / 2 - x @ x / 2 - x[0] ** 2 * x[1], x, u)
        T = h.uniform(0, 0.1, 20)
        start = {"q0": [0.1, 0.2], "v0": [0.3, 0.0]}
        by_hand = h.solve(h.variation(V, T) + h.force(-u[0] / 5 + 2 * x[1], -u[1] / 5 + 2 * x[0]), **start)
        swap = np.array([[0, 1], [1, 0]])
        for f in (-u / 5 + 2 * (swap @ x), (-1 * u + 10 * np.array([x[1], x[0]])) / 5, [-u[0] / 5 + 2 * x[1], -u[1] / 5 + 2 * x[0]]):
            np.testing.assert_allclose(h.solve(h.variation(V, T) + h.force(f), **start).q, by_hand.q, rtol=1e-13)
        self.assertEqual(repr(h.Lagrangian(np.dot(u, u) / 2 + (x - u) @ (x + u), x, u)), repr(h.Lagrangian(h.dot(u, u) / 2 + h.dot(x - u, x + u), x, u)))
        self.assertEqual(h.solve(h.variation(V, T) + h.force(-u), **start).q.shape, (21, 2))  # a vector is a force
        self.assertEqual(len({x, u}), 2)
        self.assertFalse(x == u)

    def test_constants_of_mpmath(self):
        import mpmath

        with mpmath.workdps(50):
            self.assertIn("3.14159265358979323846264338327950288419716939937510", repr(mpmath.pi * q))
            T = h.uniform(0, mpmath.pi / 1000, 3)
            self.assertEqual(h.uniform(0, mpmath.pi, 3).kind(), "50 digits")
            made = h.solve(h.variation(h.Lagrangian(v**2 / 2 - mpmath.pi * q**2 / 2, q, v), T), q0=mpmath.e, v0=0)
            same = h.solve(h.variation(h.Lagrangian(v**2 / 2 - h.pi * q**2 / 2, q, v), T), q0=mpmath.e + 0, v0=0)
            self.assertLess(abs(made.q[-1] - same.q[-1]), mpmath.mpf("1e-47"))


class Refused(unittest.TestCase):
    def says(self, error, sentence, what):
        with self.assertRaises(error) as caught:
            what()
        self.assertIn(sentence, str(caught.exception))

    def test_formulas(self):
        self.says(h.Unreadable, "L, line 1, column 9: 'k' has no meaning: there are q, t, v", lambda: h.Lagrangian("v^2/2 - k*q"))
        self.says(h.Unreadable, "L, line 1, column 11: ')' was expected, and there is the end", lambda: h.Lagrangian("v^2/2 - (q"))
        self.says(h.Unreadable, "'v' has no meaning: there are q, t, w", lambda: h.Lagrangian(v**2 / 2, "q", "w"))
        self.says(TypeError, "neither true nor false; what depends on a condition is hilger.where", lambda: 1 if q < 1 else 2)
        self.says(TypeError, "unsupported operand", lambda: q + "a")
        self.says(TypeError, "a formula or a number was expected, and here is a str", lambda: h.sin("q"))
        self.says(h.NotFinite, "a number in a formula is finite", lambda: q + float("inf"))
        self.says(h.InvalidParameter, "each name has one meaning, and 'q' was given two", lambda: h.Lagrangian(v**2, q, q))
        self.says(h.InvalidParameter, "the parameter 'k' is a number", lambda: h.Lagrangian("v^2/2 - k*q", k="heavy"))
        self.says(h.InvalidParameter, "parameters are given by their names, which are texts, and here is 1", lambda: h.Lagrangian("v^2/2", parameters={1: 1}))
        self.says(h.InvalidParameter, "at most 1000000 coordinates, and here are 100000000001", lambda: h.Lagrangian("v[100000000000]^2"))
        self.says(TypeError, "dot and norm take vectors", lambda: h.dot(q, q))
        self.says(TypeError, "a time scale is made of real numbers", lambda: h.TimeScale([0, 1j]))

    def test_deep_ones(self):
        terms = 20_000
        chain = sum((h.cos(k * q) for k in range(2, terms)), h.cos(q))
        for formula in (chain, h.read(" + ".join(f"cos({k}*q)" for k in range(1, terms)))):
            long = h.Lagrangian(v**2 / 2 - formula / terms**3, q, v)
            self.assertIn("operations", repr(long))
            self.assertEqual(len(h.solve(h.variation(long, h.uniform(0, 1e-3, 3)), q0=1.0, v0=0.0)), 4)
            self.assertEqual(len(h.solve(long, (0, 0.01), q0=1.0, v0=0.0, accuracy=1e-6).q.shape), 1)
            self.assertEqual(h.solve_many(h.variation(long, h.uniform(0, 1e-3, 3)), q0=np.ones(2), v0=0.0).failed, {})
            self.assertIn("int long_step(double h", h.variation(long, T).c_code("long"))
            del long
        self.says(h.Unreadable, "at most 400 levels", lambda: h.read("(" * terms + "q" + ")" * terms))

        def from_the_right():
            x = q
            for _ in range(terms):
                x = q + x
            return x

        self.says(h.InvalidParameter, "at most 400 levels", from_the_right)

    def test_too_large(self):
        EL = h.variation(L, h.uniform(0, 1e-3, 10**12))
        self.says(h.InvalidParameter, "GiB or more, and this machine has", lambda: h.solve(EL, q0=1.0, v0=0.0))
        self.says(h.InvalidParameter, "1000000000001 states of each of 3 members take 4.47e+04 GiB or more", lambda: h.solve_many(EL, q0=np.ones(3), v0=0.0, every=1))

    def test_operators(self):
        exact = h.TimeScale(["0", "1/3", "1"])
        self.says(TypeError, "n = 0, 1, 2, ... times by A**n, and here is n = 1.5", lambda: h.sigma**1.5)
        self.says(TypeError, "n = 0, 1, 2, ... times by A**n, and here is n = -1", lambda: h.sigma**-1)
        self.says(TypeError, "has a value for each point of T, and here is 5", lambda: h.apply(h.Delta_plus, 5, T))
        self.says(h.InvalidParameter, "a value of a function on T is a real number, and here is 'x'", lambda: h.apply(h.Delta_plus, lambda t: "x", T))
        self.says(h.InvalidParameter, "here is one that rounds", lambda: h.apply(h.Delta_plus, lambda t: float(t), exact))
        self.says(h.InvalidParameter, "here is one that rounds", lambda: h.apply(h.Delta_plus, [0.0, 1, 2], exact))
        self.assertEqual(list(h.apply(h.Delta_plus, ["0", "1/3", 1], exact)[1]), [1, 1])
        self.says(h.Mismatch, "each coordinate has its velocity", lambda: h.Lagrangian(v**2, h.variables("x[2]"), v))
        self.says(IndexError, "has the components 0 to 1", lambda: h.variables("x", 2)[2])
        self.says(h.InvalidParameter, "variables are written as in 'q v'", lambda: h.variables("q; v"))
        self.assertEqual(repr(h.variables(["q", "v"])), repr(h.variables("q v")))
        self.says(TypeError, "variables are named in a text, as in 'q v', and here is 3", lambda: h.variables(3))
        self.says(TypeError, 'machine code is "on", "off" or "at once", and here is True', lambda: h.machine_code(True))
        self.says(TypeError, "C code has a name, a text, and here is 3", lambda: EL.c_code(3))
        self.says(TypeError, "a time scale is a list of points, and here is 5; h.uniform", lambda: h.TimeScale(5))
        self.says(TypeError, "a formula or a number was expected, and here is a ndarray", lambda: h.Lagrangian(h.variables("x", 2) / 2))
        self.says(h.InvalidParameter, "an operator is divided by 0", lambda: h.sigma / 0)
        self.says(TypeError, "q0 is made of real numbers", lambda: h.solve(EL, q0=np.array([1 + 2j])[0], v0=0))
        self.says(TypeError, "q0 is made of real numbers", lambda: h.solve_many(EL, q0=np.array([1 + 2j, 0]), v0=[0.0, 0.0]))
        self.says(TypeError, "a function on T is made of real numbers, and (1+0j) is none", lambda: h.apply(h.sigma, lambda t: np.exp(1j * t), T))
        self.says(TypeError, "a scale, as h.uniform(0, 0.1, 100), was expected, and here is [0, 1, 2]", lambda: h.apply(h.sigma, [0, 1, 4], [0, 1, 2]))

    def test_list_of_methods(self):
        with contextlib.redirect_stdout(io.StringIO()) as said:
            h.methods()
        names = [line.split()[0] for line in said.getvalue().splitlines()[:-1]]
        self.assertEqual(names, list(h._core.methods))
        for name in names:
            self.assertEqual(h.variation(L, T, name).method.name, name)

    def test_problems(self):
        self.says(h.InvalidParameter, "determine a solution, and here is q0 with nothing", lambda: h.solve(EL, q0=1.0))
        self.says(h.InvalidParameter, "and here is q0 with v0 and p0", lambda: h.solve(EL, q0=1.0, v0=0, p0=0))
        self.says(h.Mismatch, "q0 is one number, and here are 2", lambda: h.solve(EL, q0=[1, 2], v0=0))
        self.says(h.NotFinite, "finite", lambda: h.solve(EL, q0=float("nan"), v0=0))
        self.says(h.InvalidParameter, "there is no method 'gauss-3': there are order-one, ", lambda: h.gauss(3))
        self.says(h.InvalidScale, "the step h of a time scale is positive", lambda: h.solve(h.variation(L, h.uniform(0, -1, 3)), q0=1, v0=0))
        self.says(h.InvalidScale, "needs two points", lambda: h.TimeScale([1]))
        for points, error, sentence in (
            ([3, 2, 1], h.InvalidScale, "increase, and point 1, 2, comes after 3"),
            ([0, 0], h.InvalidScale, "increase, and point 1, 0, comes after 0"),
            (["1/3", Fraction(2, 6)], h.InvalidScale, "increase, and point 1, 1/3, comes after 1/3"),
            ([Decimal(2), Decimal(1)], h.InvalidScale, "increase, and point 1, 1, comes after 2"),
            (["a", "b"], h.InvalidScale, "are numbers, and point 0 is 'a'"),
            (["0", "1/0"], h.InvalidScale, "are numbers, and point 1 is '1/0'"),
            ([0, float("nan")], h.InvalidScale, "are finite, and point 1 is nan"),
            ([0, float("inf")], h.InvalidScale, "are finite, and point 1 is inf"),
            ([Decimal(0), Decimal("nan")], h.InvalidScale, "are finite, and point 1 is NaN"),
            ([0, (1, 2), 3], TypeError, "a number was expected, and here is (1, 2)"),
            ([0, None], TypeError, "a number was expected, and here is None"),
        ):
            self.says(error, sentence, lambda: h.TimeScale(points))
        self.says(h.InvalidParameter, "numbers of one kind", lambda: h.uniform(0.5, Fraction(1, 2), 3))
        exact = h.variation(L, h.uniform(0, Fraction(1, 2), 3))
        self.says(h.InvalidParameter, "here is one that rounds", lambda: h.solve(exact, q0=0.5, v0=0))
        self.says(h.Unreadable, "cos has no exact value in rationals",
                  lambda: h.solve(h.variation(h.Lagrangian(v**2 / 2 + h.cos(q), q, v), exact.scale), q0=1, v0=0))
        self.says(h.Mismatch, "a force has one formula for each coordinate, and here are 2 for 1", lambda: EL + h.force(v, v))
        self.says(TypeError, "unsupported operand", lambda: EL + 1)
        self.says(h.InvalidParameter, "with fractional damping the method is mid-point",
                  lambda: h.solve(h.variation(L, T, h.verlet) + h.damping(0.1, 0.5), q0=1, v0=0))
        self.says(h.InvalidParameter, "a history is direct(), blocks(), exponentials() or exponentials(1e-8), and not 'all'", lambda: h.solve(EL + h.damping(0.1, 0.5), q0=1, v0=0, history="all"))
        self.says(h.InvalidParameter, "the order alpha lies between 0 and 2, and here is 2.5", lambda: h.damping(0.1, 2.5))
        self.says(h.InvalidParameter, "λ of theta lies between 0 and 1, and here is 1", lambda: h.theta(1))
        self.says(h.InvalidParameter, "λ is a real number, and here is 'x'", lambda: h.theta("x"))
        self.says(h.InvalidParameter, "the parameter 'k' is a list of numbers, and of none here", lambda: h.Lagrangian("v^2/2 - k*q^2", k=[]))
        self.says(h.InvalidParameter, "pi is the number 3.14159..., and the name of nothing else", lambda: h.Lagrangian("v^2/2 - pi*q", pi=3))
        self.says(h.InvalidParameter, "a guess has a row, or a number, for each point of T, and here is 5", lambda: h.solve(EL, q0=1, qN=0, guess=5))
        self.says(h.Mismatch, "q0 is one number, and here are 2", lambda: h.solve(EL, q0=[1, [2]], v0=0))
        self.says(h.InvalidParameter, "what passes zero is a function of t, q and p, and here is 'q'", lambda: h.solve(EL, q0=1, v0=0).events("q"))
        self.says(TypeError, "A**n, and here is n = -1", lambda: h.sigma**-1)
        self.says(h.StepFailure, "singular", lambda: h.solve(h.variation(h.Lagrangian("q^2/2"), T), q0=1, v0=0))
        self.says(h.OutsideDomain, "outside of the solution", lambda: h.solve(EL, q0=1, v0=0)(2.0))
        self.says(h.InvalidParameter, "go with a Lagrangian", lambda: h.solve(EL, (0, 1), q0=1, v0=0, accuracy=1e-3))
        self.says(h.InvalidParameter, "64 epsilon", lambda: h.solve(L, (0, 1), q0=1, v0=0, accuracy=1e-17))

    def test_lengths(self):
        three = h.variation(h.Lagrangian("dot(v, v)/2 - dot(q, q)/2", "q[3]", "v[3]"), T)
        for given in ({"v0": 0}, {"v0": [0, 0]}, {"v0": []}, {"v0": [0] * 4}, {"p0": [0]}, {"q1": [1, 2]}, {"qN": [1]}):
            self.says(h.Mismatch, "has 3 numbers, one for each coordinate", lambda: h.solve(three, q0=[1, 2, 3], **given))
        self.says(h.Mismatch, "q0 has 3 numbers", lambda: h.solve(three, q0=1, v0=[0, 0, 0]))
        self.says(h.Mismatch, "v0 has 3 numbers",
                  lambda: h.solve(three.lagrangian, (0, 1), q0=[1, 2, 3], v0=[0, 0], accuracy=1e-3))

    def test_a_solution_of_another_shape(self):
        x = h.solve(h.variation(h.Lagrangian("dot(v, v)/2 - dot(q, q)/2", "q[3]", "v[3]"), T), q0=[1, 2, 3], v0=[0, 0, 0])
        narrow = x.p[:, :1]
        x.p, whole = narrow, x.p
        self.says(h.Mismatch, "L has 3 coordinates, and a state has 1", lambda: x(0.05))
        x.p, x.q = whole, x.q[:, :2]
        self.says(h.Mismatch, "L has 3 coordinates, and a state has 2", x.residual)
        self.says(h.Mismatch, "L has 3 coordinates, and a state has 2", lambda: x(0.05))

    def test_parameters_of_any_name(self):
        for named in (
            h.Lagrangian("m*u^2/2 - q*x^2/2", "x", "u", m=1, q=3),
            h.Lagrangian("v*u^2/2 - time*x^2/2", "x", "u", v=1, parameters={"time": 3}),
            h.Lagrangian("parameters*u^2/2 - 3*x^2/2", "x", "u", parameters={"parameters": 1}),
        ):
            plain = h.Lagrangian("v^2/2 - 3*q^2/2")
            here, there = (h.solve(h.variation(of, h.uniform(0, Fraction(1, 2), 5)), q0=1, v0=0).q for of in (named, plain))
            self.assertEqual(list(here), list(there))
        self.assertEqual(repr(h.Lagrangian("u^2/2", q="x", v="u")), repr(h.Lagrangian("u^2/2", "x", "u")))
        self.says(h.InvalidParameter, "time is the name of the time, and here is 1.6", lambda: h.Lagrangian("v^2/2", time=1.6))
        self.says(h.InvalidParameter, "each parameter is given once, and m twice", lambda: h.Lagrangian("m*v^2/2", m=1, parameters={"m": 2}))
        self.says(h.InvalidParameter, "parameters are given by their names", lambda: h.Lagrangian("v^2/2", parameters=[1]))

    def test_names_in_forces_are_known_at_once(self):
        self.says(h.Unreadable, "'k'", lambda: EL + h.force("-k*v"))

    def test_kinds(self):
        self.says(TypeError, "a method, as h.midpoint or h.gauss(4), was expected", lambda: h.variation(L, T, 2))
        self.says(TypeError, "a scale, as h.uniform", lambda: h.variation(L, [0, 1, 2]))
        self.says(TypeError, "a Lagrangian was expected", lambda: h.variation("v^2/2", T))
        self.says(TypeError, "the number of steps is a whole number", lambda: h.uniform(0, 0.1, 10.0))
        self.says(TypeError, "a history is direct()", lambda: h.solve(EL, q0=1, v0=0, history=h.direct))
        for wrong in ("exponentials:abc", "exponentials:", "window:1000", "directly"):
            self.says(h.InvalidParameter, "a history is direct()", lambda: h.solve(EL, q0=1, v0=0, history=wrong))
        self.says(TypeError, "here is the text '012'", lambda: h.TimeScale("012"))
        self.says(h.InvalidParameter, "at least one component", lambda: h.variables("q[0]"))
        self.says(h.InvalidParameter, "from q0 and v0, and nothing else", lambda: h.solve(L, (0, 1), q0=1, v0=0, p0=1, accuracy=1e-3))
        self.says(h.Unreadable, "a number ends before '−'", lambda: h.Lagrangian("v^2/2−q^2/2"))

    def test_what_is_no_number_and_no_operator(self):
        self.says(h.InvalidParameter, "the order alpha is a real number, and here is 'half'", lambda: h.damping(0.4, "half"))
        x = h.variables("x", 2)
        self.says(TypeError, "an operator acts on another one", lambda: h.sigma[q])
        self.says(TypeError, "the factor of an operator is a number, and here is the formula q", lambda: h.sigma * q)
        for wrong in (lambda: h.sigma * x, lambda: x * h.sigma):
            self.says(TypeError, "unsupported operand type", wrong)

    def test_errors_have_the_types_that_python_has_for_them(self):
        self.assertTrue(issubclass(h.Unreadable, ValueError))
        self.assertTrue(issubclass(h.Unreadable, h.Error))
        self.assertTrue(issubclass(h.StepFailure, h.Error))


class Taken(unittest.TestCase):
    def test_ways_to_write_a_formula(self):
        expected = list(h.solve(EL, q0=1.0, v0=0.0).q)
        half = Fraction(1, 2)
        for L2 in (
            h.Lagrangian("v^2/2 - q^2/2"),
            h.Lagrangian("(v**2 - q**2)/2"),
            h.Lagrangian("k*v^2 - k*q^2  # a comment", k=0.5),
            h.Lagrangian("w[0]*v^2 - w[1]*q^2", w=[half, "1/2"]),
            h.Lagrangian(half * v**2 - Decimal("0.5") * q**2, q, v),
            h.Lagrangian(v**2 / 2 - h.where(q < 100, q**2 / 2, q), [q], [v]),
            h.Lagrangian(h.read("v^2/2 - abs(q)^2/2"), "q", "v"),
        ):
            for a, b in zip(h.solve(h.variation(L2, T), q0=1, v0=0).q, expected):
                self.assertAlmostEqual(a, b, delta=64 * 2.3e-16)

    def test_components_in_a_text_say_how_many_there_are(self):
        text = "(v[0]^2 + v[1]^2)/2 + B*(q[0]*v[1] - q[1]*v[0])/2 - k[3]*q[0]"
        taken = h.Lagrangian(text, B=2, k=[1, 2, 3, 4])
        self.assertEqual(taken.dimension, 2)
        self.assertEqual(repr(taken), repr(h.Lagrangian(text, "q[2]", "v[2]", B=2, k=[1, 2, 3, 4])))
        self.assertEqual(h.Lagrangian("dot(v, v)/2 - q[ 2 ]").dimension, 3)
        self.assertEqual(h.Lagrangian("v^2/2 - dq[3]*q", dq=[0, 0, 0, 1]).dimension, 1)
        with self.assertRaisesRegex(h.Unreadable, r"'v' is a number, and has no components; a vector says how many, as in Lagrangian\(L, \"q\[3\]\""):
            h.Lagrangian("dot(v, v)/2 - q")
        with self.assertRaisesRegex(h.Unreadable, "'q' is a number, and has no components"):
            h.Lagrangian("v^2/2 - q[0]", "q", "v")

    def test_functions_are_lagrangians(self):
        x, u = h.variables("x u", 2)
        k = 3
        for L, text in (
            (h.Lagrangian(lambda q, v: v**2 / 2 - h.cos(q)), "L = v²/2 − cos(q)"),
            (h.Lagrangian(lambda x, u: u**2 / 2 - h.cos(x)), "L = v²/2 − cos(q)"),
            (h.Lagrangian(lambda v, q: v**2 / 2 - h.cos(q)), "L = v²/2 − cos(q)"),
            (h.Lagrangian(lambda q, v, t: v**2 / 2 - q * t), "L = v²/2 − q·t"),
            (h.Lagrangian(lambda s, q, v: v**2 / 2 - q * s, time="s"), "L = v²/2 − q·s"),
            (h.Lagrangian(lambda q, v, k=k: v**2 / 2 - k * q), "L = v²/2 − 3·q"),
            (h.Lagrangian(lambda v: v**2 / 2), "L = v²/2"),
            (h.Lagrangian(lambda x, u: u @ u / 2 - x[0] * x[1], x, u), "L = (u₀² + u₁²)/2 − x₀·x₁"),
        ):
            self.assertEqual(repr(L), text)
        with self.assertRaisesRegex(h.InvalidParameter, r"a function of \(q, v\), or of ones that it names t, q, v, and here is one of \(x, u, t\)"):
            h.Lagrangian(lambda x, u, t: x)
        with self.assertRaisesRegex(h.InvalidParameter, r"a function of \(q, v\).* and here is one of \(\)"):
            h.Lagrangian(np.sin)

    def test_numpy_and_texts(self):
        EL2 = h.variation(h.Lagrangian(v**2 / 2 - (1 - np.cos(q)), q, v), T)
        EL3 = h.variation(h.Lagrangian(v**2 / 2 - (1 - h.cos(q)), q, v), T)
        self.assertEqual(list(h.solve(EL2, q0=1, v0=0).q), list(h.solve(EL3, q0=1, v0=0).q))
        a, b = (h.solve(EL + h.force(f), q0=1, v0=0).q for f in ("-v/10", [-v / 10]))
        self.assertEqual(list(a), list(b))
        x = h.solve(h.variation(L, h.uniform("0", "1/10", 5)), q0=1, qN=Fraction(1, 2))
        self.assertEqual(list(x.t), [Fraction(i, 10) for i in range(6)])

    def test_what_numpy_makes_of_formulas(self):
        x = h.variables("x", 2)
        one = np.float64(0.5)
        for made, text in (
            (h.where(one < q, q, v), "if(0.5 < q, q, v)"),
            (h.where(one >= q, q, v), "if(q <= 0.5, q, v)"),
            (one * q + np.float64(2) / v, "0.5*q + 2.0/v"),
            (np.arctan2(one, q), "atan2(0.5, q)"),
            (np.hypot(q, v), "hypot(q, v)"),
            (np.arcsin(q) + np.arctan(v), "asin(q) + atan(v)"),
            (np.arcsinh(q) + h.acosh(q) * np.arctanh(v), "asinh(q) + acosh(q)*atanh(v)"),
            (np.minimum(q, 1.0), "min(q, 1.0)"),
            (np.arctan2(x, np.array([1.0, 2.0]))[1], "atan2(x[1], 2.0)"),
            ((np.array([1.0, 2.0]) * q)[1], "2.0*q"),
            ((np.sin(x) @ x), "sin(x[0])*x[0] + sin(x[1])*x[1]"),
            (q * np.longdouble("0.1"), "q*0.1"),
        ):
            self.assertEqual(repr(made), text)
        self.assertEqual((h.damping("1/4", Fraction(1, 2)).rho, np.float64(2) * h.sigma), (0.25, 2 * h.sigma))

    def test_long_formulas(self):
        chain = sum((q - k) ** 2 for k in range(5000))
        self.assertRegex(repr(h.Lagrangian(v**2 / 2 - chain, q, v)), "L = a formula of [0-9]+ operations")
        self.assertRegex(repr(h.Lagrangian("v^2/2 - sum(i, 1, 100000, (q - i)^2)")), "L = a formula of [0-9]+ operations")

    def test_printed(self):
        self.assertEqual(repr(L), "L = v²/2 − q²/2")
        self.assertEqual(L._repr_latex_(), "$L = \\frac{{v}^{2}}{2} - \\frac{{q}^{2}}{2}$")
        self.assertIn("[∂L/∂q(⋆)]½,₋ − Δ½,₋[∂L/∂v(⋆)] = 0", repr(EL))
        self.assertIn("\\begin{aligned}", EL._repr_latex_())
        self.assertIn("−0.2 D^0.5 q", repr(EL + h.damping(0.2, 0.5)))


if __name__ == "__main__":
    unittest.main()
