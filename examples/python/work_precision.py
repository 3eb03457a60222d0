# SPDX-License-Identifier: BSL-1.0
"""What accuracy costs: Kepler's problem, eccentricity 0.6, under five methods."""

import time

import numpy as np
from pictures import plt, quick, save

import hilger as h

q, v = h.variables("q v", 2)
L = h.Lagrangian(h.dot(v, v) / 2 + 1 / h.norm(q), q, v)
start = {"q0": [0.4, 0.0], "v0": [0.0, 2.0]}
best = h.solve(L, (0, 20), **start, accuracy=1e-12).q[-1]
figure, axes = plt.subplots(figsize=(7, 5))
slopes = {}
for method in (h.order_one, h.midpoint, h.verlet, h.gauss(4), h.gauss(8)):
    seconds, errors = [], []
    for steps in 2 ** np.arange(7, 10 if quick else 15):
        EL = h.variation(L, h.uniform(0, 20 / steps, int(steps)), method)
        begin = time.perf_counter()
        end = h.solve(EL, **start).q[-1]
        seconds.append(time.perf_counter() - begin)
        errors.append(np.abs(end - best).max())
    axes.loglog(seconds, errors, ".-", label=method.name)
    slopes[method.name] = np.log2(errors[-2] / errors[-1])
axes.set(xlabel="seconds", ylabel="error at t = 20", ylim=(1e-12, 10))
axes.legend()
save(figure, __file__)
if not quick:
    assert abs(slopes["mid-point"] - 2) < 0.1 and abs(slopes["verlet"] - 2) < 0.1
