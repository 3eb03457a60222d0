# SPDX-License-Identifier: BSL-1.0
"""An oscillator whose damping remembers: −ρ D^α q for several α, between a spring (0) and friction (1)."""

import numpy as np
from pictures import plt, save

import hilger as h

L = h.Lagrangian("v^2/2 - q^2/2")
EL = h.variation(L, h.uniform(0, 0.01, 4000))
figure, axes = plt.subplots(figsize=(8, 4))
for alpha in (0.25, 0.5, 0.75, 1.0, 1.5):
    x = h.solve(EL + h.damping(0.3, alpha), q0=1.0, v0=0.0, history=h.exponentials())
    x.plot(axes, label=f"α = {alpha}")
axes.legend()
save(figure, __file__)

damped = EL + h.damping(0.3, 0.5)
by_sum, by_modes = (h.solve(damped, q0=1.0, v0=0.0, history=how).q for how in (h.direct(), h.exponentials()))
print(f"the sum over all that was, and a sum of exponentials: {np.abs(by_sum - by_modes).max():.1e} apart")
assert np.abs(by_sum - by_modes).max() < 1e-11
