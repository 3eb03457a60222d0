# SPDX-License-Identifier: BSL-1.0
"""A pendulum: its phase portrait, and an energy that does not drift."""

import numpy as np
from pictures import plt, save

import hilger as h

q, v = h.variables("q v")
L = h.Lagrangian(v**2 / 2 - (1 - h.cos(q)), q, v)
EL = h.variation(L, h.uniform(0, 0.1, 2000), h.midpoint)
print(EL)

figure, (phase, energy) = plt.subplots(1, 2, figsize=(11, 4))
many = h.solve_many(EL, q0=0.0, v0=np.linspace(0.2, 2.4, 12), every=1)
for q_of, p_of in zip(many.q, many.p):
    phase.plot((q_of + np.pi) % (2 * np.pi) - np.pi, p_of, ",")
phase.set(xlabel="q", ylabel="p", title="mid-point, h = 0.1")
x = h.solve(EL, q0=2.0, v0=0.0)
x.plot_energy_error(energy)
energy.set_title("energy error")
save(figure, __file__)
assert x.residual() < 64
assert np.ptp(x.energy()) < 2e-3
