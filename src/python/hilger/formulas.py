# SPDX-License-Identifier: BSL-1.0
"""Variables and functions for formulas. Numbers in formulas keep their digits: 0.1 is one tenth in rationals."""

from __future__ import annotations

import operator
import re
from typing import Iterable, Iterator, Sequence, Union

import numpy as np

from . import _core
from ._core import Expression

Number = Union[int, float, "fractions.Fraction", "decimal.Decimal", "mpmath.mpf"]  # noqa: F821
Formula = Union[Expression, Number]

t: Expression = _core.variable("t")
"""The time."""
pi: Expression = _core.variable("pi")


class Vector(np.lib.mixins.NDArrayOperatorsMixin):
    """A vector of coordinates or velocities: q[0], len(q), dot(q, q). Arithmetic makes numpy's arrays of formulas, -v/5 + 2*q, and q @ v is
    a formula."""

    __eq__ = object.__eq__
    __ne__ = object.__ne__
    __hash__ = object.__hash__

    def __init__(self, name: str, size: int) -> None:
        self.name, self.size = name, size

    def __len__(self) -> int:
        return self.size

    def __getitem__(self, k: int) -> Expression:
        if isinstance(k, slice):
            raise TypeError(f"a component of {self!r} is {self.name}[k], one at a time: [{self.name}[k] for k in range({self.size})[1:]]")
        try:
            return _core.element(self.name, range(self.size)[k])  # negative indices count from the end
        except IndexError:
            raise IndexError(f"{self!r} has the components 0 to {self.size - 1}, and here is {k}") from None

    def __iter__(self) -> Iterator[Expression]:
        return (self[k] for k in range(self.size))

    def __array__(self, dtype: object = None, copy: "bool | None" = None) -> np.ndarray:
        return np.array(list(self), dtype=object)

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: object, **more: object) -> object:
        return _by_numpy(self, ufunc, method, *inputs, **more)

    def __repr__(self) -> str:
        return f"{self.name}[{self.size}]"


def variables(names: "str | Iterable[str]", size: int = 0) -> "tuple[Expression | Vector, ...] | Expression | Vector":
    """Variables by name: ``q, v = variables("q v")`` are numbers, ``variables("q v", 3)`` and ``variables("q[3] v[3]")`` vectors."""
    made = []
    if not isinstance(names, str):
        if not np.iterable(names) or not all(isinstance(name, str) for name in names):
            raise TypeError(f"variables are named in a text, as in 'q v', and here is {names!r}")
        names = " ".join(names)
    for word in names.replace(",", " ").split():
        found = re.fullmatch(r"([^\W\d]\w*)(?:\[(\d+)\])?", word)
        if found is None:
            raise _core.InvalidParameter(f"variables are written as in 'q v' or 'q[3] v[3]', and here is '{word}'")
        d = int(found[2]) if found[2] else size
        if found[2] == "0" or not isinstance(d, int) or d < 0:
            raise _core.InvalidParameter(f"a vector has at least one component, and here is '{word}' with {d}")
        made.append(Vector(found[1], d) if d > 0 else _core.variable(found[1]))
    return made[0] if len(made) == 1 else tuple(made)


def read(text: str) -> Expression:
    """The formula in a text, as "m*v^2/2 - m*g*l*(1 - cos(q))"."""
    return _core.read(text, "the formula")


def _name(x: object) -> "str | None":
    return x.name if isinstance(x, (Expression, Vector)) else None


def dot(x: Sequence[Formula], y: Sequence[Formula]) -> Expression:
    """x[0]*y[0] + x[1]*y[1] + ..."""
    for z in (x, y):
        if not hasattr(z, "__len__"):
            raise TypeError(f"dot and norm take vectors, as h.variables makes them of \"q[3]\", and here is {z!r}")
    if len(x) != len(y):
        raise _core.Mismatch(f"dot takes vectors of one length, and these have {len(x)} and {len(y)} components")
    if len(x) == 0:
        return _core.as_expression(0)
    products = [_core.as_expression(a) * b for a, b in zip(x, y)]
    total = products[0]
    for product in products[1:]:
        total = total + product
    return total


def norm(x: Sequence[Formula]) -> Expression:
    """The square root of dot(x, x)."""
    return sqrt(dot(x, x))


def _function_of_one(name: str):
    def function(x: Formula) -> Expression:
        return _core.call(name, x)

    function.__name__ = function.__qualname__ = name
    function.__doc__ = f"{name}(x) of a formula or a number: a formula, in as many digits as it is evaluated in; float() of one without variables."
    return function


for _f in _core.functions_of_one:
    if _f != "abs":  # Python has its own
        globals()[_f] = _function_of_one(_f)


def atan2(y: Formula, x: Formula) -> Expression:
    """The angle of (x, y)."""
    return _core.call("atan2", y, x)


def hypot(x: Formula, y: Formula) -> Expression:
    """sqrt(x**2 + y**2)"""
    return _core.call("hypot", x, y)


def minimum(x: Formula, y: Formula) -> Expression:
    """The smaller one; its derivative jumps where they cross."""
    return _core.call("min", x, y)


def maximum(x: Formula, y: Formula) -> Expression:
    """The larger one; its derivative jumps where they cross."""
    return _core.call("max", x, y)


_of_two = {
    np.less: operator.lt,
    np.less_equal: operator.le,
    np.greater: operator.gt,
    np.greater_equal: operator.ge,
    np.arctan2: atan2,
    np.hypot: hypot,
    np.minimum: minimum,
    np.maximum: maximum,
}


def _by_numpy(self, ufunc: np.ufunc, method: str, *inputs: object, **more: object) -> object:
    """Apply a numpy function to formulas element by element. numpy calls methods as q.sin() of the first argument for functions it does not
    know, and turns comparisons into true or false, which formulas are not: these use _of_two."""
    objects = [np.asarray(x).astype(object) for x in inputs]
    if not all(isinstance(x, np.ndarray) for x in more.get("out", ())):
        more.pop("out")  # Q += 1 makes another Q
    if method == "__call__" and ufunc in _of_two and not more:
        return np.frompyfunc(_of_two[ufunc], 2, 1)(*objects)
    return getattr(ufunc, method)(*objects, **more)


Expression.__array_ufunc__ = _by_numpy
