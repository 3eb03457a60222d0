# SPDX-License-Identifier: BSL-1.0
"""One Lagrangian under several embeddings, and each equation as it is derived."""

import numpy as np
from pictures import plt, save

import hilger as h

L = h.Lagrangian("v^2/2 - q^4/4")
figure, axes = plt.subplots(figsize=(7, 4))
largest = {}
own = h.embedding((2 * h.identity + h.sigma) / 3, h.Delta_plus)
for method in (h.order_one, own, h.midpoint, h.verlet, h.gauss(2), h.gauss(4)):
    EL = h.variation(L, h.uniform(0, 0.25, 400), method)
    if method.name not in ("verlet", "gauss-4"):
        print(f"{method.name}\n{EL}\n")
    x = h.solve(EL, q0=1.0, v0=0.0)
    error = np.abs(x.energy() - 0.25)
    largest[method.name] = error.max()
    axes.semilogy(x.t, error + 1e-17, label=method.name)
axes.set(xlabel="t", ylabel="energy error", title="L = v²/2 − q⁴/4, h = 0.25")
axes.legend()
save(figure, __file__)
assert largest["gauss-4"] < largest["gauss-2"] < largest["mid-point"] < largest[own.name] < largest["order-one"]
