# SPDX-License-Identifier: BSL-1.0
"""A throw from one place to another: the path that joins two ends, in double and exactly."""

from fractions import Fraction

from pictures import plt, save

import hilger as h

L = h.Lagrangian("(u^2 + v^2)/2 - g*y - k*x*y", h.variables("x y"), h.variables("u v"), g=1, k="1/10")
figure, axes = plt.subplots(figsize=(7, 4))
for steps in (4, 16, 64):
    x = h.solve(h.variation(L, h.uniform(0, 4 / steps, steps)), q0=[0, 0], qN=[5, 1])
    axes.plot(x.q[:, 0], x.q[:, 1], ".-", label=f"{steps} steps", linewidth=0.7)
axes.set(xlabel="x", ylabel="y")
axes.legend()
save(figure, __file__)

exact = h.solve(h.variation(L, h.TimeScale(["0", "1", "3/2", "3", "4"])), q0=[0, 0], qN=[5, 1])
print("on {0, 1, 3/2, 3, 4}:", *(f"({a}, {b})" for a, b in exact.q))
assert exact.residual() == 0
assert all(isinstance(z, Fraction) for z in exact.q[1])
