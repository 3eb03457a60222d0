# SPDX-License-Identifier: BSL-1.0
"""Many solutions of one equation at once."""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping
from typing import Callable, Optional

import numpy as np

from . import _core
from .equations import Equation
from .scales import real, require_real
from .solving import bar_of, require_history, require_room


class Ensemble:
    """Many trajectories of one equation: t, and q and p of members x kept points (x coordinates, if there are several).

    `failed` maps the numbers of failed members to reasons; q and p are NaN at points not reached. `lanes` is the number of members that
    stepped together, 1 if each was alone.
    """

    def __init__(self, t, q, p, failed: "dict[int, str]", lanes: int = 1) -> None:
        self.t, self.q, self.p, self.failed, self.lanes = t, q, p, failed, lanes

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
    parameters: "Optional[dict[str, np.ndarray]]" = None,
    every: "Optional[int]" = None,
    threads: "Optional[int]" = None,
    lanes: bool = True,
    history: str = "exponentials",
    comm: "Optional[object]" = None,
    progress: "bool | Callable[[int], None]" = False,
) -> Ensemble:
    """Solve an equation from many initial values: q0 and one of v0, p0, q1 are arrays with a row (or a number) for each member, or one row
    for all; so is each of `parameters`, the values of parameters of L that differ between members.

    Keeps the first point of each member, every `every`-th, and the last one; by default the first and the last. Members are independent, and
    the result does not depend on the number of threads, to the last bit; by default there is one thread for each processor. An interrupt
    returns the members so far. `progress` is as in `solve`, and counts complete members.

    With `comm`, MPI.COMM_WORLD of mpi4py, each rank computes its share of the members, by default in one thread, and every rank gets the
    whole result, which does not depend on the number of ranks; `progress` counts within the share.

    With `lanes` several members step at once, in the lanes of the processor's registers, for the methods order_one, order_one_left,
    midpoint, verlet and kahan_li_8, up to six coordinates, no memory, no branches, no formulas of thousands of operations and no functions
    with a restricted domain (log, asin, atan2, q^v). Results agree with `solve` to rounding. The number of lanes changes no bit, but on a
    processor without AVX2 functions of the C library may differ in the last bits. Without lanes, or a C compiler (see `machine_code`),
    members agree with `solve` to the last bit.
    """
    for what, n in (("every", every), ("threads", threads)):
        if n == 0 and what == "threads":
            raise _core.InvalidParameter("threads is a positive number, or None for as many as there are processors, and was 0")
        if n is not None and (not isinstance(n, (int, np.integer)) or abs(n) >= (2**31 if what == "threads" else 2**62)):
            raise _core.InvalidParameter(f"{what} is a whole number, and was {n!r}")
    if not isinstance(equation, Equation):
        raise TypeError(f"an equation, as h.variation(L, T, h.midpoint), is solved, and not a {type(equation).__name__}")
    require_history(history)
    if not isinstance(lanes, (bool, np.bool_)):
        raise _core.InvalidParameter(f"lanes is True or False, and was {lanes!r}")
    if not isinstance(parameters, (Mapping, type(None))):
        raise _core.InvalidParameter('parameters are given by their names, as {"g": np.linspace(1, 10, 5)}')
    given = {name: x for name, x in (("v0", v0), ("p0", p0), ("q1", q1)) if x is not None}
    if len(given) != 1:
        raise _core.InvalidParameter(f"q0 and one of v0, p0 and q1 determine a solution, and here is q0 with {' and '.join(given) or 'nothing'}")
    (name, other), = given.items()
    if equation.scale.kind() != "double":
        raise _core.InvalidParameter("ensembles are computed in double, on scales of floats")
    d, scalar = equation.lagrangian.dimension, equation.lagrangian.is_scalar

    def array(x: object, what: str) -> np.ndarray:
        require_real(x, what)
        if np.ma.is_masked(x):
            raise _core.InvalidParameter(f"{what} has masked numbers: give the members without them, as x[~x.mask]")
        try:
            if any(y is None for y in ([x] if np.ndim(x) == 0 else np.ravel(x) if np.asarray(x).dtype == object else ())):
                raise TypeError("None is none")
            if np.asarray(x).dtype.kind in "mM":
                raise TypeError("times of numpy have a unit, and these are numbers")
            if np.asarray(x).dtype.kind in "US":
                return np.vectorize(lambda y: real(str(y), what), otypes=[float])(x)
            return np.asarray(x, dtype=float)
        except (OverflowError, TypeError, ValueError) as why:
            raise _core.InvalidParameter(f"{what} is an array of numbers that a double can be: {why}") from None

    def rows(x: object, what: str) -> np.ndarray:
        x = array(x, what)
        x = x.reshape(-1, 1) if scalar and x.ndim < 2 else np.atleast_2d(x)
        if x.ndim != 2 or x.shape[1] != d:
            raise _core.Mismatch(f"{what} has a row of {d} numbers for each member, and here is an array of shape {x.shape}")
        return x

    start, more = rows(q0, "q0"), rows(other, name)
    brought = {}
    own = equation.lagrangian._parameters
    if parameters and equation.besides:
        raise _core.InvalidParameter("members differ in parameters of one Lagrangian, and this is the equation of several: each can be solved alone")
    for parameter, x in (parameters or {}).items():
        if parameter not in own:
            raise _core.InvalidParameter(f"there is no parameter '{parameter}': there are {', '.join(sorted(own)) or 'none'}")
        x = array(x, parameter)
        size = len(own[parameter]) if isinstance(own.get(parameter), list) else 0
        x = x.reshape(-1, 1) if size == 0 and x.ndim < 2 else np.atleast_2d(x)
        if x.ndim != 2 or x.shape[1] != max(size, 1):
            raise _core.Mismatch(f"{parameter} has {max(size, 1)} numbers for each member, and here is an array of shape {x.shape}")
        brought[parameter] = x
    columns = [("q0", start), (name, more), *brought.items()]
    members = next((len(x) for _, x in columns if len(x) != 1), 1)
    if any(len(x) not in (1, members) for _, x in columns):
        sizes = ", ".join(f"{len(x)} of {what}" for what, x in columns)
        raise _core.Mismatch(f"each array has as many rows as there are members, or one, and here are {sizes}")
    problem = equation._stated(history)
    if parameters:
        problem = problem.brought_by_members(list(parameters))
    a, b, *own = (np.ascontiguousarray(np.broadcast_to(x, (members, x.shape[1]))) for _, x in columns)
    each = np.hstack(own) if own else np.empty((members, 0))
    stride = max(equation.scale.steps, 1) if every is None else every
    if stride > 0:
        kept = -(-equation.scale.steps // stride) + 1
        require_room(2 * members * kept * d, f"{kept} states of each of {members} members", "a larger `every` keeps fewer of them")
    cast = _core.Cast(problem, equation.method.name, lanes, equation._points())
    rank, ranks = (0, 1) if comm is None else (comm.Get_rank(), comm.Get_size())
    share = slice(members * rank // ranks, members * (rank + 1) // ranks)
    threads = threads or (os.cpu_count() or 1 if comm is None else 1)
    bar = bar_of(progress, share.stop - share.start, " members")
    try:
        t, *made = _core.walk_all(cast, a[share], name, b[share], each[share], stride, threads, bar)
    finally:
        if hasattr(bar, "close"):
            bar.close()
    if comm is not None:
        made = (sum(parts[1:], parts[0]) if isinstance(parts[0], list) else np.concatenate(parts) for parts in zip(*comm.allgather(made)))
    q, p, why = made
    failed = {k: reason for k, reason in enumerate(why) if reason}
    if "interrupted" in failed.values():
        warnings.warn("interrupted; what there is was kept", RuntimeWarning, stacklevel=2)
    elif len(failed) == members > 0:
        warnings.warn(f"no member came to the end; the first: {failed[0]}", RuntimeWarning, stacklevel=2)
    return Ensemble(t, q[:, :, 0] if scalar else q, p[:, :, 0] if scalar else p, failed, cast.lanes)
