# SPDX-License-Identifier: BSL-1.0
"""Many solutions of one equation at once."""

from __future__ import annotations

import os
import warnings
from typing import Callable, Optional

import numpy as np

from . import _core
from .equations import Equation


class Ensemble:
    """Many trajectories of one equation: t, and q and p of members x kept points (x coordinates, where there are several).

    `failed` says of members that did not come to the end why; where they did not get to, q and p are NaN.
    """

    def __init__(self, t, q, p, failed: "dict[int, str]") -> None:
        self.t, self.q, self.p, self.failed = t, q, p, failed

    def __len__(self) -> int:
        return len(self.q)

    def __repr__(self) -> str:
        return f"<{len(self)} members, {len(self.t)} points of each{f', {len(self.failed)} failed' if self.failed else ''}>"


def solve_many(
    equation: Equation,
    *,
    q0: "np.ndarray",
    v0: "Optional[np.ndarray]" = None,
    p0: "Optional[np.ndarray]" = None,
    q1: "Optional[np.ndarray]" = None,
    every: "Optional[int]" = None,
    threads: "Optional[int]" = None,
    history: str = "exponentials",
    progress: "Optional[Callable[[int], None]]" = None,
) -> Ensemble:
    """Solve an equation from many initial values: q0 and one of v0, p0, q1 are arrays with a row (or a number) for each member, or one row
    for all.

    Kept are the first point of each, every so many, and the last one; where `every` is not said the first and the last. Each member is
    computed as if it were alone, so that the result does not depend on the number of threads, which is that of the processors where it is
    not said. An interrupt keeps what there is. `progress` gets the number of members that are done.
    """
    given = {name: x for name, x in (("v0", v0), ("p0", p0), ("q1", q1)) if x is not None}
    if len(given) != 1:
        raise _core.InvalidParameter(f"q0 and one of v0, p0 and q1 determine a solution, and here is q0 with {' and '.join(given) or 'nothing'}")
    (name, other), = given.items()
    if equation.scale.kind() != "double":
        raise _core.InvalidParameter("ensembles are computed in double, on scales of floats")
    d, scalar = equation.lagrangian.dimension, equation.lagrangian.is_scalar

    def rows(x: object, what: str) -> np.ndarray:
        x = np.asarray(x, dtype=float)
        x = x.reshape(-1, 1) if scalar and x.ndim < 2 else np.atleast_2d(x)
        if x.ndim != 2 or x.shape[1] != d:
            raise _core.Mismatch(f"{what} has a row of {d} numbers for each member, and here is an array of shape {x.shape}")
        return x

    a, b = rows(q0, "q0"), rows(other, name)
    if len(a) != len(b) and 1 not in (len(a), len(b)):
        raise _core.Mismatch(f"q0 and {name} have as many rows as there are members, and here are {len(a)} and {len(b)}")
    members = max(len(a), len(b))
    a, b = (np.ascontiguousarray(np.broadcast_to(x, (members, d))) for x in (a, b))
    stride = equation.scale.steps if every is None else every
    t, q, p, why = _core.walk_all(equation._motion(history), a, name, b, stride, threads or os.cpu_count() or 1, progress)
    failed = {k: reason for k, reason in enumerate(why) if reason}
    if "interrupted" in failed.values():
        warnings.warn("interrupted; what there is was kept", RuntimeWarning, stacklevel=2)
    return Ensemble(t, q[:, :, 0] if scalar else q, p[:, :, 0] if scalar else p, failed)
