# SPDX-License-Identifier: BSL-1.0
"""Operators of the calculus on time scales, composed, and embeddings made of them.

    A = (h.identity + h.sigma) / 2
    mine = h.embedding(A, h.Delta_plus)          # L(A q, Delta_plus q), summed with weights mu
    print(h.variation(L, T, mine))               # the discrete Euler-Lagrange equation that follows
    h.adjoint(h.Delta_plus) == -h.Delta_minus    # True: integration by parts
"""

from __future__ import annotations

from typing import Callable, Sequence, Union

import numpy as np

from . import _core
from ._core import Expression, Operator
from .equations import Method
from .scales import TimeScale, Uniform, digits, exact, real, require_real, rounds
from .solutions import digits_of, numbers_from

identity = _core.read_operator("identity")
sigma = _core.read_operator("sigma")
rho = _core.read_operator("rho")
Delta_plus = _core.read_operator("Delta_plus")
Delta_minus = _core.read_operator("Delta_minus")


def adjoint(A: Operator) -> Operator:
    """The operator B with <A f, g> = <f, B g> for all f that vanish at the ends of T; see Operator.adjoint."""
    if not isinstance(A, Operator):
        raise TypeError(f"an operator, as h.Delta_plus, was expected, and here is {A!r}")
    return A.adjoint()


def embedding(position: "Operator | str", velocity: "Operator | str", integral: str = "delta") -> Method:
    """How L(q, v) is read on T: L(A q, B q) at each point, under the Delta integral (weights mu) or the nabla integral (weights nu). The
    operators use the two ends of one step, and must be consistent: A 1 = 1, B 1 = 0, B t = 1."""
    sums = {"delta": "integral", "nabla": "nabla_integral"}
    if integral not in sums:
        raise _core.InvalidParameter(f'the integral of an embedding is "delta" or "nabla", and here is {integral!r}')
    parts = []
    for x, name in ((position, "position"), (velocity, "velocity")):
        if not isinstance(x, (Operator, str)):
            raise TypeError(f"the {name} of an embedding is an operator, as h.sigma, or its text, and here is {x!r}")
        parts.append((_core.read_operator(x) if isinstance(x, str) else x).text)
    return Method(f"{sums[integral]}(L({', '.join(parts)}))")


def apply(A: Operator, f: "Callable | Sequence", T: "Uniform | TimeScale") -> tuple:
    """The points of T at which A[f] lives, and its values there. f is a function of t, or has a value for each point of T. In double;
    exact if T is made of fractions, and in 50 digits if of mpf."""
    if not isinstance(A, Operator):
        raise TypeError(f"an operator, as h.Delta_plus, was expected, and here is {A!r}")
    if not isinstance(T, (Uniform, TimeScale)):
        raise TypeError(f"a scale, as h.uniform(0, 0.1, 100), was expected, and here is {T!r}")
    kind = T.kind()
    if isinstance(f, Expression):
        raise TypeError(f"f is a function of t, as a lambda, or has a value for each point of T, and here is the formula {f!r}")
    of = {"double": float, "exact": exact, "50 digits": lambda x: x}[kind]
    with digits_of(kind):
        if isinstance(T, Uniform):
            start, step = (of(x) for x in (T.start, T.step))
            points = [start + i * step for i in range(T.steps + 1)]
        else:
            points = [of(x) for x in T.points]
        if not callable(f) and (isinstance(f, str) or not np.iterable(f)):
            raise TypeError(f"f is a function of t, as a lambda, or has a value for each point of T, and here is {f!r}")
        values = [f(t) for t in points] if callable(f) else list(f)
    require_real(values, "a function on T")
    if kind == "exact" and any(rounds(y) for y in values):
        raise _core.InvalidParameter("on a scale of fractions a function has values that are fractions or whole numbers, and here is one that rounds")
    if kind == "double":
        values = [real(y, "a value of a function on T") for y in values]
        front, made = A._on_points(np.array(points, float), np.array(values, float))
        return np.array(points, float)[front : front + len(made)], made
    on = A._on_points_exactly if kind == "exact" else A._on_points_in_50_digits
    front, made = on([digits(x) for x in points], [digits(x) for x in values])
    made = numbers_from(kind, made)
    return np.array(points, dtype=object)[front : front + len(made)], made
