# SPDX-License-Identifier: BSL-1.0
"""Lagrangians, made of a formula, a text or a function."""

from __future__ import annotations

import copy
import inspect
import pickle
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Callable, Optional, Sequence, Union

import numpy as np

from . import _core
from ._core import Expression
from .formulas import Formula, Number, Vector, variables
from .scales import digits

MOST_COORDINATES = 1_000_000
Variables = Union[str, Expression, Vector, Sequence[Union[Expression, Vector]]]


def _all(x: Variables) -> list:
    if isinstance(x, str):
        x = variables(x)
    return list(x) if isinstance(x, (tuple, list)) else [x]


def _size(x: "Expression | Vector") -> int:
    return x.size if isinstance(x, Vector) else 0


def _components(text: str) -> str:
    """The dimension of q and v in a text, as "[2]" for q[0] and v[1]; empty if they are numbers."""
    numbers = [int(i) for i in re.findall(r"\b[qv]\s*\[\s*(\d+)\s*\]", text)]
    return f"[{max(numbers) + 1}]" if numbers else ""


def _called(L: Callable, time: str, qs: list, vs: list) -> "Formula":
    """The formula returned by a function of (q, v), or of variables that it names."""
    q, v = (x[0] if len(x) == 1 else x for x in (qs, vs))
    known = {time: variables(time), getattr(q, "name", "q"): q, getattr(v, "name", "v"): v}
    try:
        taken = [name for name, x in inspect.signature(L).parameters.items() if x.default is x.empty and x.kind == x.POSITIONAL_OR_KEYWORD]
    except ValueError:  # numpy's functions have no signature
        taken = []
    if taken and {*taken} <= {*known}:
        return L(**{name: known[name] for name in taken})
    if len(taken) == 2:
        return L(q, v)
    raise _core.InvalidParameter(
        f"a Lagrangian is a function of (q, v), or of ones that it names {', '.join(known)}, and here is one of ({', '.join(taken)})"
    )


class Lagrangian:
    """L(t, q, v): a formula, a function of (q, v) or (t, q, v) that makes one, or a text such as "m*v^2/2 - m*g*l*(1 - cos(q))" with the
    parameters in it as keywords.

    q and v are variables, lists of them, or their names; by default q and v, with as many components as a text uses, as v[1]. `time` is the
    name of the time. Coordinates are numbered in the given order. Parameters of any name, as "time", can be given in a dictionary:
    parameters={"time": 3}.
    """

    #: g of dt = g(q) dτ, by transform_time
    _rate: "Optional[Expression]" = None

    def __init__(
        self,
        L: "Formula | str | Callable",
        q: "Optional[Variables]" = None,
        v: "Optional[Variables]" = None,
        /,
        *,
        time: str = "t",
        parameters: "Optional[Mapping[str, object]]" = None,
        **more: object,
    ) -> None:
        if not isinstance(time, str):
            raise _core.InvalidParameter(f"time is the name of the time, and here is {time!r}: a parameter of that name is given in parameters={{...}}")
        if not isinstance(parameters, (Mapping, type(None))):
            raise _core.InvalidParameter(f'parameters are given by their names, as {{"g": 9.81}}, and here is {parameters!r}')
        if nameless := [name for name in parameters or () if not isinstance(name, str)]:
            raise _core.InvalidParameter(f"parameters are given by their names, which are texts, and here is {nameless[0]!r}")
        # q= and v= are the coordinates, or parameters if coordinates are given by position
        components = _components(L) if isinstance(L, str) else ""
        q, v = (more.pop(name, name + components) if x is None else x for x, name in ((q, "q"), (v, "v")))
        if twice := sorted({*more} & {*(parameters or ())}):
            raise _core.InvalidParameter(f"each parameter is given once, and {', '.join(twice)} twice")
        parameters = {**more, **(parameters or {})}
        qs, vs = _all(q), _all(v)
        if [_size(x) for x in qs] != [_size(x) for x in vs]:
            raise _core.Mismatch("each coordinate has its velocity, of the same size")
        for x in (*qs, *vs):
            if not isinstance(x, (Expression, Vector)) or x.name is None:
                raise _core.InvalidParameter("coordinates and velocities are variables, as h.variables makes them")
        if sum(max(_size(x), 1) for x in qs) > MOST_COORDINATES:
            raise _core.InvalidParameter(f"a Lagrangian has at most {MOST_COORDINATES} coordinates, and here are {sum(max(_size(x), 1) for x in qs)}")
        self.coordinates = [(x.name, y.name, _size(x)) for x, y in zip(qs, vs)]
        self.time = time
        if callable(L):
            L = _called(L, time, qs, vs)
        if isinstance(L, np.ndarray) and L.size == 1:
            L = L.item()
        formula = _core.read(L, "L") if isinstance(L, str) else _core.as_expression(L)
        given = {}
        for name, x in parameters.items():
            try:
                given[name] = digits(x) if isinstance(x, str) or not hasattr(x, "__len__") or np.ndim(x) == 0 else [digits(y) for y in x]
            except _core.InvalidParameter as why:
                raise _core.InvalidParameter(f"the parameter {name} is a number or a list of numbers: {why}") from None
        self._formula, self._parameters = formula, given
        try:
            self._problem = self._stated()
        except _core.Unreadable as why:
            if "has no components" not in str(why):
                raise
            raise _core.Unreadable(f'{why}; a vector says how many, as in Lagrangian(L, "q[3]", "v[3]")') from None

    def _stated(self) -> "_core.Problem":
        problem = _core.Problem(self._formula, self.coordinates, self.time, self._parameters)
        if self._rate is not None:
            problem.transform_time(self._rate, self.coordinates)
        return problem

    def _said(self) -> tuple:
        formulas = pickle.dumps(self._formula), pickle.dumps(self._rate)
        return formulas, tuple(self.coordinates), self.time, repr(sorted(self._parameters.items()))

    def __eq__(self, other: object) -> bool:
        return self._said() == other._said() if isinstance(other, Lagrangian) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._said())

    def __getstate__(self) -> dict:
        return {name: x for name, x in self.__dict__.items() if name != "_problem"}

    def __setstate__(self, kept: dict) -> None:
        self.__dict__.update(kept)
        self._problem = self._stated()

    @property
    def dimension(self) -> int:
        """The number of coordinates."""
        return self._problem.dimension()

    @property
    def is_scalar(self) -> bool:
        """Whether the only coordinate is a number: states are then numbers, not vectors of one component."""
        return len(self.coordinates) == 1 and self.coordinates[0][2] == 0

    def _written(self, latex: bool) -> str:
        try:
            return self._problem.written(self.coordinates, self.time, latex)
        except _core.NoFormula:
            return "\\text{a formula with branches}" if latex else "a formula with branches"

    def _rate_written(self, latex: bool) -> str:
        if self._rate is None:
            return ""
        return f",\\quad dt = (\\text{{{self._rate}}})\\, d\\tau" if latex else f",   dt = ({self._rate}) dτ"

    def __repr__(self) -> str:
        return f"L = {self._written(False)}{self._rate_written(False)}"

    def _repr_latex_(self) -> str:
        return f"$L = {self._written(True)}{self._rate_written(True)}$"


@dataclass(frozen=True)
class InversePotential:
    """The rate that inverse_potential returns."""

    lagrangian: Lagrangian


def inverse_potential(L: Lagrangian) -> InversePotential:
    """The rate g(q) = 1 / L(q, 0) = -1 / U(q) of transform_time, for an attraction U < 0: of two bodies it is their distance, in a unit."""
    if not isinstance(L, Lagrangian):
        raise TypeError(f"a Lagrangian has a potential, and here is {L!r}")
    return InversePotential(L)


def sundman(gamma: Number, distance: "Optional[Formula]" = None) -> Expression:
    """The rate g(q) = r**gamma of transform_time (Sundman 1912), r = |q| of all coordinates together or a given distance. With gamma = 1
    steps on an orbit of Kepler's problem are equal in its eccentric anomaly, with 2 in the true one."""
    return _core.call("sundman", gamma, *(() if distance is None else (distance,)))


def transform_time(L: Lagrangian, g: "Formula | str | InversePotential") -> Lagrangian:
    """L in the time τ with dt = g(q) dτ, g > 0: a scale that follows the motion (Poincaré's transformation).

    g is a formula of the coordinates, or a text, sundman(gamma) or inverse_potential(L). variation(transform_time(L, g), T, method) has its T
    in τ. Every method steps g(q) (L(q, q'/g(q)) + E), with E the energy of the initial values q0 and v0 = dq/dt or p0, so that it is as
    symplectic and reversible as without g. x.t of the solution are times t, the sums of g over the nodes of the method; x(t), x.events
    and x.energy() are of L in t. Raises InvalidParameter for an L that contains the time, for forces and damping, which change the energy,
    and if g is not positive.
    """
    if not isinstance(L, Lagrangian):
        raise TypeError(f"a Lagrangian is transformed, and here is {L!r}")
    if L._rate is not None:
        raise _core.InvalidParameter("the time of this Lagrangian is transformed already: multiply the rates")
    if isinstance(g, InversePotential):
        if g.lagrangian != L:
            raise _core.Mismatch("the potential is that of the Lagrangian, and here are two Lagrangians")
        g = _core.variable("inverse_potential")
    made = copy.copy(L)
    made._rate = _core.read(g, "g") if isinstance(g, str) else _core.as_expression(g)
    made._problem = made._stated()
    return made
