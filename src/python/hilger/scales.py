# SPDX-License-Identifier: BSL-1.0
"""Time scales, and the identities of the calculus on them."""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from typing import Iterable

import numpy as np

from . import _core


def kind_of(numbers: Iterable[object]) -> str:
    """The scalar type for numbers: 'double', 'exact' for fractions, '50 digits' for mpf and Decimal."""
    kinds = set()
    for x in numbers:
        name = type(x).__name__
        if x is None or np.ndim(x) > 0:
            raise TypeError(f"a number was expected, and here is {x!r}")
        if isinstance(x, str):
            kinds.add("exact")
        elif isinstance(x, Fraction):
            kinds.add("exact")
        elif name in ("mpf", "constant", "Decimal"):
            kinds.add("50 digits")
        elif not isinstance(x, (int, np.integer)):
            kinds.add("double")
    if len(kinds) > 1:
        raise _core.InvalidParameter(f"numbers of one kind are expected, and here are {' and '.join(sorted(kinds))}")
    return kinds.pop() if kinds else "double"


def require_real(x: object, what: str) -> None:
    """Raise TypeError for a complex number, or one in a list: float() of an array would drop the imaginary part."""
    numbers = x if isinstance(x, (list, tuple)) else np.ravel(x) if np.iscomplexobj(x) else [x]
    for y in numbers:
        if isinstance(y, (complex, np.complexfloating)):
            raise TypeError(f"{what} is made of real numbers, and {y} is none")


def rounds(x: object) -> bool:
    """Whether x is a rounded number, and not a fraction."""
    return isinstance(x, (float, np.floating)) or type(x).__name__ in ("mpf", "constant")


_long = 4000
"""Digits of a piece of a whole number: Python refuses to read or write many more at once."""


def whole_from(text: str) -> int:
    """A whole number of any length."""
    minus, text = text.startswith("-"), text.lstrip("+-")
    n = 0
    for k in range(0, len(text), _long):
        piece = text[k : k + _long]
        n = n * 10 ** len(piece) + int(piece)
    return -n if minus else n


def _text_of_whole(n: int) -> str:
    pieces, rest = [], abs(n)
    while rest >= 10**_long:
        rest, piece = divmod(rest, 10**_long)
        pieces.append(str(piece).zfill(_long))
    return "-" * (n < 0) + str(rest) + "".join(reversed(pieces))


def fraction_from(text: str) -> Fraction:
    """A rational in the engine's notation, a/b."""
    above, _, below = text.partition("/")
    return Fraction(whole_from(above), whole_from(below) if below else 1)


def exact(x: object) -> Fraction:
    """A whole number, a fraction, or a text as "1/3" or "0.5"."""
    text = digits(x)
    return fraction_from(text) if text.lstrip("+-").replace("/", "", 1).isdecimal() else Fraction(text)


def digits(x: object) -> str:
    """A number as text, without loss."""
    if isinstance(x, _core.Expression):
        raise _core.InvalidParameter(f"a number was expected, and here is the formula {x!r}: write it into the formula, or float() of it")
    if isinstance(x, str):
        return x.strip()
    if isinstance(x, Fraction):
        return f"{_text_of_whole(x.numerator)}/{_text_of_whole(x.denominator)}"
    if type(x).__name__ in ("mpf", "constant"):
        import mpmath

        if type(x).__name__ == "constant":  # mpmath.pi, in as many digits as requested
            x = x(dps=60)
        return mpmath.nstr(x, 55, min_fixed=0, max_fixed=0)
    if isinstance(x, (int, np.integer)):
        return _text_of_whole(int(x))
    if type(x).__name__ == "Decimal":
        return str(x)
    if isinstance(x, np.longdouble):
        return str(x)
    try:
        return repr(float(x))
    except (TypeError, ValueError):
        raise _core.InvalidParameter(f"a number was expected, and here is {x!r}") from None


def real(x: object, what: str) -> float:
    """A number, or a text as "1/3", as a double. @raises InvalidParameter when it is not real, NotFinite when double overflows"""
    try:
        if isinstance(x, (complex, np.complexfloating)):
            raise TypeError
        return float(Fraction(x) if isinstance(x, str) else x)
    except (TypeError, ValueError, ZeroDivisionError):
        raise _core.InvalidParameter(f"{what} is a real number, and here is {x!r}") from None
    except OverflowError:
        raise _core.NotFinite(f"{what} is a number that double has, and here is {x!r}") from None


class _Scale:
    """Scales of one class are equal when their points are, in any notation."""

    def __eq__(self, other: object) -> bool:
        return self._numbers() == other._numbers() if type(self) is type(other) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._numbers())

    def _numbers(self) -> tuple:
        given = self._given()
        return tuple(exact(x) for x in given) if kind_of(given) == "exact" else given


@dataclass(frozen=True, eq=False)
class Uniform(_Scale):
    """T = {start + i*step}, i = 0 ... steps."""

    start: object
    step: object
    steps: int

    def kind(self) -> str:
        return kind_of((self.start, self.step))

    def _given(self) -> tuple:
        return (self.start, self.step, self.steps)


class TimeScale(_Scale):
    """Any increasing points, two or more. Fractions and texts as "1/3" are exact, and so are computations on them. Raises InvalidScale
    unless the points increase and are finite, and TypeError unless they are a list of numbers."""

    def __init__(self, points: Iterable[object]) -> None:
        if isinstance(points, str):
            raise TypeError(f"a time scale is a list of points, and here is the text {points!r}")
        if not np.iterable(points):
            raise TypeError(f"a time scale is a list of points, and here is {points!r}; h.uniform(start, step, steps) makes one of equal steps")
        if isinstance(points, (set, frozenset)):
            raise TypeError("a time scale is a list of points from the first to the last, and a set has no first: h.TimeScale(sorted(...))")
        self.points = tuple(points)
        require_real(list(self.points), "a time scale")
        if len(self.points) < 2:
            raise _core.InvalidScale(f"a time scale needs two points, and here are {len(self.points)}")
        self._require_increasing()

    def _require_increasing(self) -> None:
        number = {"double": lambda x: real(x, "a point of a time scale"), "exact": exact, "50 digits": lambda x: Decimal(digits(x))}[self.kind()]
        before = None
        for i, x in enumerate(self.points):
            try:
                at = number(x)
            except (ValueError, ZeroDivisionError):
                raise _core.InvalidScale(f"the points of a time scale are numbers, and point {i} is {x!r}") from None
            if not isinstance(at, Fraction) and (at != at or abs(at) == float("inf")):
                raise _core.InvalidScale(f"the points of a time scale are finite, and point {i} is {x}")
            if i > 0 and not before < at:
                raise _core.InvalidScale(f"the points of a time scale increase, and point {i}, {x}, comes after {self.points[i - 1]}")
            before = at

    def kind(self) -> str:
        return kind_of(self.points)

    @property
    def steps(self) -> int:
        return len(self.points) - 1

    def __repr__(self) -> str:
        points = [str(x) for x in self.points]
        if len(points) > 12:
            return f"<TimeScale of {len(points)} points, {', '.join(points[:3])} ... {points[-1]}>"
        return f"TimeScale({points})"

    def _given(self) -> tuple:
        return self.points


def uniform(start: object, step: object, steps: int) -> Uniform:
    """T = {start + i*step}, i = 0 ... steps; in rationals if start or step is a Fraction, in 50 digits for mpmath's mpf."""
    if isinstance(steps, bool) or not hasattr(steps, "__index__"):
        raise TypeError(f"the number of steps is a whole number, and here is {steps!r}")
    if not 0 < int(steps) < 2**62:
        raise _core.InvalidScale(f"the number of steps is a positive whole number, and here is {steps!r}")
    T = Uniform(start, step, int(steps))
    if T.kind() == "double":
        for x, what in ((start, "the start of a scale"), (step, "the step of a scale")):
            real(x, what)
    return T


@dataclass(frozen=True)
class Identity:
    """An identity of the calculus, tried with random functions in exact rationals."""

    name: str
    source: str
    """S: Cresson and Safi 2022, B: Bourdin, Cresson, Greff and Inizan 2013."""
    equalities: int
    holds: bool
    failure: str


def identities(T: "TimeScale | Uniform") -> "list[Identity]":
    """Every identity that holds on any scale, proved on T: each equality is one of rationals, without a tolerance."""
    if not isinstance(T, (Uniform, TimeScale)):
        raise TypeError(f"a scale, as h.TimeScale(['0', '1/3', '1']), was expected, and here is {T!r}")
    if isinstance(T, Uniform):
        start, step = exact(T.start), exact(T.step)
        points = [digits(start + i * step) for i in range(T.steps + 1)]
    else:
        points = [digits(x) for x in T.points]
    return [Identity(*row) for row in _core.identities(points)]
