# SPDX-License-Identifier: BSL-1.0
"""The outer solar system, 18 degrees of freedom: a formula of all pairs, traced once (data: Hairer, Lubich, Wanner, Geometric Numerical
Integration, I.2.4)."""

import csv
import itertools
import pathlib

import numpy as np
from pictures import plt, quick, save

import hilger as h

file = pathlib.Path(__file__).resolve().parents[2] / "src/data/outer_solar_system.csv"
lines = [line for line in file.read_text().splitlines() if not line.startswith("#")]
rows = list(csv.reader(lines[1:]))  # after the names of the columns
names, mass = [row[0] for row in rows], np.array([float(row[1]) for row in rows])
place, speed = (np.array([[float(z) for z in row[k : k + 3]] for row in rows]) for k in (2, 5))
G = 2.95912208286e-4

n = len(names)
q, v = h.variables("q v", 3 * n)
kinetic = sum(mass[k // 3] * v[k] ** 2 / 2 for k in range(3 * n))
pairs = itertools.combinations(range(n), 2)
potential = sum(-G * mass[a] * mass[b] / h.norm([q[3 * a + k] - q[3 * b + k] for k in range(3)]) for a, b in pairs)
L = h.Lagrangian(kinetic - potential, q, v)
x = h.solve(h.variation(L, h.uniform(0, 100, 200 if quick else 2000), h.midpoint), q0=place.ravel(), v0=speed.ravel())

figure, (orbits, energy) = plt.subplots(1, 2, figsize=(11, 5))
for k in range(n):
    orbits.plot(x.q[:, 3 * k], x.q[:, 3 * k + 1], linewidth=0.8, label=names[k])
orbits.set(aspect="equal", title=f"{x.t[-1]:.0f} days, h = 100 days")
orbits.legend(fontsize="small")
x.plot_energy_error(energy)
save(figure, __file__)
H = x.energy()
assert np.ptp(H) < 4e-3 * abs(H[0])
