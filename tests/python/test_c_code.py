# SPDX-License-Identifier: BSL-1.0
"""The step in C, compiled by cc and run beside the solution."""

import ctypes
import pathlib
import subprocess
import tempfile
import unittest

import needs
import numpy as np

import hilger as h


@needs.c_compiler
class Code(unittest.TestCase):
    def step_of(self, EL, name, folder):
        source, library = (pathlib.Path(folder) / f"{name}.{end}" for end in ("c", "so"))
        source.write_text(EL.c_code(name))
        flags = ["-std=c99", "-O2", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off", "-shared", "-fPIC"]
        subprocess.run([*needs.CC, *flags, str(source), "-o", str(library), "-lm"], check=True)
        return getattr(ctypes.CDLL(str(library)), f"{name}_step")

    def follows(self, EL, name, q0, v0, timed=False):
        with tempfile.TemporaryDirectory() as folder:
            step = self.step_of(EL, name, folder)
            x = h.solve(EL, q0=q0, v0=v0)
            q, p = (np.atleast_1d(a[0]).copy() for a in (x.q, x.p))
            v = np.atleast_1d(np.array(v0, dtype=float))
            pointer = ctypes.POINTER(ctypes.c_double)
            for i in range(len(x) - 1):
                time = (ctypes.c_double(x.t[i]),) if timed else ()
                done = step(*time, ctypes.c_double(EL.scale.step), *(a.ctypes.data_as(pointer) for a in (q, p, v)))
                self.assertEqual(done, 0)
            self.assertLess(np.abs(q - x.q[-1]).max(), 1e-12)
            self.assertLess(np.abs(p - x.p[-1]).max(), 1e-12)

    def test_steps(self):
        q, v = h.variables("q v")
        pendulum = h.Lagrangian(v**2 / 2 - (1 - h.cos(q)), q, v)
        kepler = h.Lagrangian("dot(v, v)/2 + 1/norm(q)", "q[2]", "v[2]")
        for method in (h.order_one, h.order_one_left, h.midpoint):
            T = h.uniform(0, 0.05, 100)
            self.follows(h.variation(pendulum, T, method), "pendulum", 1.0, 0.5)
            self.follows(h.variation(kepler, T, method), "kepler", [1.0, 0.0], [0.0, 1.1])
        driven = h.Lagrangian(v**2 / 2 - q**2 / 2 + q * h.sin(h.t), q, v)
        self.follows(h.variation(driven, T) + h.force(-v / 10), "driven", 1.0, 0.5, timed=True)

    def test_refused(self):
        EL = h.variation(h.Lagrangian("v^2/2 - q^2/2"), h.uniform(0, 0.1, 10))
        self.assertRaisesRegex(h.InvalidParameter, "without fractional damping", (EL + h.damping(1, 0.5)).c_code, "x")
        self.assertRaisesRegex(h.InvalidParameter, "C names are letters", EL.c_code, "2x")
        verlet = h.variation(EL.lagrangian, EL.scale, h.verlet)
        self.assertRaisesRegex(h.InvalidParameter, "and not of verlet", verlet.c_code, "x")
        branches = h.variation(h.Lagrangian("v^2/2 - if(q < 0, q^2, q^2/2)"), EL.scale)
        self.assertRaisesRegex(h.NoFormula, "compares", branches.c_code, "x")


if __name__ == "__main__":
    unittest.main()
