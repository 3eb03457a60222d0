# SPDX-License-Identifier: BSL-1.0
"""The identities of the calculus on a scale of one's own, in rationals: no tolerance."""

from fractions import Fraction

from pictures import plt, save

import hilger as h

cantor = [Fraction(0), Fraction(1)]
for _ in range(4):
    cantor = sorted({x / 3 for x in cantor} | {(2 + x) / 3 for x in cantor})
proved = h.identities(h.TimeScale(cantor))
for identity in proved:
    print(f"{identity.name:45} {identity.source:32} {identity.equalities:5} equalities {'hold' if identity.holds else 'FAIL'}")

figure, axes = plt.subplots(figsize=(8, 7))
axes.barh([f"{i.name}  [{i.source}]" for i in proved], [i.equalities for i in proved])
axes.tick_params(axis="y", labelsize=6)
axes.set(xscale="log", xlabel="equalities of rationals, all exact", title="ends of the intervals of Cantor's set, 32 points")
save(figure, __file__)
assert all(identity.holds for identity in proved)
