# SPDX-License-Identifier: BSL-1.0
"""Linear structures with a memory: the equations of Newmark's scheme, with the weights of its fractional term, hold at what comes back."""

import unittest

import numpy as np

import hilger as h

q, v = h.variables("q v")
oscillator = h.Lagrangian(v**2 - 3 * q**2 / 2, q, v)  # M = 2, K = 3
T = h.uniform(0, 0.05, 200)


def power_of_series(a, alpha, count):
    """The coefficients of (a[0] + a[1] z + ...)**alpha."""
    w = [a[0] ** alpha]
    for n in range(1, count):
        w.append(sum((alpha * k - (n - k)) * a[k] * w[n - k] for k in range(1, min(n, len(a) - 1) + 1)) / (n * a[0]))
    return np.array(w)


weights = {"g-alpha-newmark": [1.5, -2, 0.5], "gl-newmark": [1, -1]}


def derivative(x, alpha, step, method):
    w = power_of_series(weights[method], alpha, len(x)) / step**alpha
    return np.array([w[: n + 1][::-1] @ x[: n + 1] for n in range(len(x))])


def what_is_left(x, r, M, step):
    """Of M (q_{n+1} - 2 q_n + q_{n-1}) / h^2 = (r_{n+1} + 2 r_n + r_{n-1}) / 4, of its largest term."""
    left = M * (x[2:] - 2 * x[1:-1] + x[:-2]) / step**2
    return np.abs(left - (r[2:] + 2 * r[1:-1] + r[:-2]) / 4).max() / np.abs(left).max()


class Structures(unittest.TestCase):
    def test_a_fractional_term(self):
        for method in (h.g_alpha_newmark, h.gl_newmark):
            for history in (h.direct(), h.blocks(), h.exponentials()):
                EL = h.variation(oscillator, T, method) + h.damping(0.4, alpha=0.5) + h.force("sin(t)")
                x = h.solve(EL, q0=0.0, v0=1.0, history=history)
                r = np.sin(x.t) - 3 * x.q - 0.4 * derivative(x.q, 0.5, 0.05, method.name)
                self.assertLess(what_is_left(x.q, r, 2.0, 0.05), 1e-11)  # rounding of q over h^2
                self.assertEqual(x.p[0], 2.0)

    def test_a_zener_material(self):
        low, high, tau, alpha = 1.0, 5.0, 0.3, 0.6
        for method in (h.g_alpha_newmark, h.gl_newmark):
            EL = h.variation(oscillator, T, method) + h.zener(low, high, tau, alpha)
            x = h.solve(EL, q0=0.0, p0=2.0)
            # q_a + tau^alpha D^alpha q_a = (1 - E_0/E_inf) q, one point after the other
            w = power_of_series(weights[method.name], alpha, len(x)) * (tau / 0.05) ** alpha
            memory = np.zeros(len(x))
            for n in range(len(x)):
                memory[n] = ((1 - low / high) * x.q[n] - w[1 : n + 1][::-1] @ memory[:n]) / (1 + w[0])
            self.assertLess(what_is_left(x.q, -high / low * 3 * (x.q - memory), 2.0, 0.05), 1e-11)

    def test_orders_against_the_other_scheme(self):
        def end(method, steps):
            EL = h.variation(oscillator, h.uniform(0, 4 / steps, steps), method) + h.damping(0.4, alpha=0.5)
            return h.solve(EL, q0=0.0, v0=1.0, history=h.blocks()).q[-1]

        fine, finer = (end(h.midpoint, n) for n in (4000, 8000))
        exact = finer + (finer - fine) / 3
        for method, order, n in ((h.g_alpha_newmark, 2, 800), (h.gl_newmark, 1, 6400)):
            errors = [abs(end(method, m) - exact) for m in (n, 2 * n)]
            self.assertAlmostEqual(np.log2(errors[0] / errors[1]), order, delta=0.02)

    def test_several_coordinates(self):
        x, y, u, w = h.variables("x y u w")
        L = h.Lagrangian(u**2 / 2 + w**2 - x**2 - (x - y) ** 2 / 2, [x, y], [u, w])
        EL = h.variation(L, T, h.g_alpha_newmark) + h.zener(1.0, 1.0, 0.1, 0.5)  # elastic: what is kept is the energy
        one = h.solve(EL, q0=[1.0, 0.0], v0=[0.0, 0.5])
        self.assertEqual(one.q.shape, (201, 2))
        self.assertLess(np.ptp(one.energy()), 1e-12)

    def test_what_is_shown(self):
        EL = h.variation(oscillator, T, h.g_alpha_newmark)
        self.assertIn("one fractional term or one material, and here are 0", repr(EL))
        self.assertIn("M q̈ + ρ Dᵅ[q] + K q = f", repr(EL + h.damping(0.4, 0.5)))
        made = EL + h.zener(1.0, 5.0, 0.3, 0.5)
        self.assertIn("E₀ = 1.0, E∞ = 5.0, τ = 0.3, α = 0.5", repr(made))
        self.assertIn("\\\\ M \\ddot{q} + \\tfrac{E_\\infty}{E_0} K (q - q_a) = f", made._repr_latex_())
        self.assertIn("\\\\ \\text{g-alpha-newmark: Newmark's", EL._repr_latex_())

    def test_what_is_refused(self):
        def says(what, call):
            with self.assertRaises(h.InvalidParameter) as raised:
                call()
            self.assertIn(what, str(raised.exception))

        EL = h.variation(oscillator, T, h.g_alpha_newmark)
        zener, damped = h.zener(1.0, 5.0, 0.3, 0.5), h.damping(0.4, 0.5)
        pendulum = h.Lagrangian("v^2/2 + cos(q)")
        says("and here are 0", lambda: h.solve(EL, q0=0, v0=1))
        says("and here are 2", lambda: h.solve(EL + damped + damped, q0=0, v0=1))
        says("and here are 2", lambda: h.solve(EL + damped + zener, q0=0, v0=1))
        says("one material, and this one has it", lambda: EL + zener + zener)
        says("a force that is not linear in q", lambda: h.solve(h.variation(pendulum, T, h.gl_newmark) + damped, q0=0, v0=1))
        says("depends on the time alone", lambda: h.solve(EL + damped + h.force(-v), q0=0, v0=1))
        says("the method is g-alpha-newmark or gl-newmark, and not 'mid-point'", lambda: h.solve(h.variation(oscillator, T) + zener, q0=0, v0=1))
        says("not below the relaxed one", lambda: h.solve(EL + h.zener(5.0, 1.0, 0.3, 0.5), q0=0, v0=1))
        says("starts from q0 and v0 or p0", lambda: h.solve(EL + damped, q0=0, q1=1))
        says("is solved from initial values", lambda: h.solve(EL + damped, q0=0, qN=1))
        says("is for uniform scales", lambda: h.solve(h.variation(oscillator, h.TimeScale([0, 1, 3]), h.gl_newmark) + damped, q0=0, v0=1))


if __name__ == "__main__":
    unittest.main()
