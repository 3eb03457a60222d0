# SPDX-License-Identifier: BSL-1.0
"""Order and chaos of Hénon and Heiles at the energy 1/8: how fast neighbours part, over a section of initial values."""

import numpy as np
from pictures import plt, quick, save

import hilger as h

x, u = h.variables("x u", 2)
U = h.dot(x, x) / 2 + x[0] ** 2 * x[1] - x[1] ** 3 / 3
EL = h.variation(h.Lagrangian(h.dot(u, u) / 2 - U, x, u), h.uniform(0, 0.2, 500 if quick else 1500), h.midpoint)

size, energy, apart = (24 if quick else 200), 1 / 8, 1e-8
y, p_y = (a.ravel() for a in np.meshgrid(np.linspace(-0.45, 0.7, size), np.linspace(-0.5, 0.5, size)))
square = 2 * energy - p_y**2 - y**2 + 2 * y**3 / 3
inside = square > 0
q0 = np.column_stack([np.zeros(inside.sum()), y[inside]])
p0 = np.column_stack([np.sqrt(square[inside]), p_y[inside]])
here, beside = (h.solve_many(EL, q0=q0 + [0, shift], p0=p0) for shift in (0, apart))
distance = np.linalg.norm(np.hstack([here.q[:, -1] - beside.q[:, -1], here.p[:, -1] - beside.p[:, -1]]), axis=1)
rate = np.full(size * size, np.nan)
rate[inside] = np.log10(distance / apart)

figure, axes = plt.subplots(figsize=(7, 6))
picture = axes.imshow(rate.reshape(size, size), origin="lower", extent=(-0.45, 0.7, -0.5, 0.5), aspect="auto", cmap="inferno")
figure.colorbar(picture, label="log₁₀ of how much a distance of 1e-8 grows")
axes.set(xlabel="y", ylabel="p_y", title=f"Hénon–Heiles, H = 1/8, t = {here.t[-1]:.0f}")
save(figure, __file__)
assert not here.failed
assert np.nanmax(rate) > np.nanmin(rate) + 1
