# SPDX-License-Identifier: BSL-1.0
"""Lagrangians, methods, and the discrete Euler-Lagrange equations that they make together."""

from __future__ import annotations

import inspect
import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Callable, Optional, Sequence, Union

import numpy as np

from . import _core
from ._core import Expression
from .formulas import Formula, Vector, variables
from .scales import TimeScale, Uniform, digits, real

Variables = Union[str, Expression, Vector, Sequence[Union[Expression, Vector]]]


def _all(x: Variables) -> list:
    if isinstance(x, str):
        x = variables(x)
    return list(x) if isinstance(x, (tuple, list)) else [x]


def _size(x: "Expression | Vector") -> int:
    return x.size if isinstance(x, Vector) else 0


def _components(text: str) -> str:
    """What a text takes of q and v, as "[2]" where that is q[0] and v[1], and nothing where they are numbers."""
    numbers = [int(i) for i in re.findall(r"\b[qv]\s*\[\s*(\d+)\s*\]", text)]
    return f"[{max(numbers) + 1}]" if numbers else ""


def _called(L: Callable, time: str, qs: list, vs: list) -> "Formula":
    """What a function of (q, v), or of variables that it names, makes of them."""
    q, v = (x[0] if len(x) == 1 else x for x in (qs, vs))
    known = {time: variables(time), getattr(q, "name", "q"): q, getattr(v, "name", "v"): v}
    try:
        taken = [name for name, x in inspect.signature(L).parameters.items() if x.default is x.empty and x.kind == x.POSITIONAL_OR_KEYWORD]
    except ValueError:  # of numpy's functions
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

    q and v are variables, lists of them, or their names: q and v where nothing is said, of as many components as a text takes of them, as
    v[1]; `time` is the name of the time. Coordinates are numbered as they are given. Parameters of any name, as "time", can be given in a
    dictionary: parameters={"time": 3}.
    """

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
        # q= and v= are the coordinates where these are not given before, and else parameters
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
            self._problem = _core.Problem(formula, self.coordinates, time, given)
        except _core.Unreadable as why:
            if "has no components" not in str(why):
                raise
            raise _core.Unreadable(f'{why}; a vector says how many, as in Lagrangian(L, "q[3]", "v[3]")') from None

    def __getstate__(self) -> dict:
        return {name: x for name, x in self.__dict__.items() if name != "_problem"}

    def __setstate__(self, kept: dict) -> None:
        self.__dict__.update(kept)
        self._problem = _core.Problem(self._formula, self.coordinates, self.time, self._parameters)

    @property
    def dimension(self) -> int:
        """The number of coordinates."""
        return self._problem.dimension()

    @property
    def is_scalar(self) -> bool:
        """One coordinate that is a number: states are numbers then, and not vectors of one."""
        return len(self.coordinates) == 1 and self.coordinates[0][2] == 0

    def _written(self, latex: bool) -> str:
        try:
            return self._problem.written(self.coordinates, self.time, latex)
        except _core.NoFormula:
            return "\\text{a formula with branches}" if latex else "a formula with branches"

    def __repr__(self) -> str:
        return f"L = {self._written(False)}"

    def _repr_latex_(self) -> str:
        return f"$L = {self._written(True)}$"


@dataclass(frozen=True)
class Method:
    """An embedding, or a composition of steps: its name, or what is summed, as "integral(L((q + sigma[q])/2, Delta_plus[q]))"."""

    name: str

    def __post_init__(self) -> None:
        if "(" in self.name:
            return  # the equation knows what the names in it mean
        kinds = {name.split(":")[0] + ":" for name in _core.methods if ":" in name}
        if self.name not in _core.methods and not any(self.name.startswith(kind) for kind in kinds):
            raise _core.InvalidParameter(f"there is no method '{self.name}': there are {', '.join(_core.methods)}")


order_one = Method("order-one")
order_one_left = Method("order-one-left")
midpoint = Method("mid-point")
verlet = Method("verlet")
lobatto_3 = Method("lobatto-3")
kahan_li_8 = Method("kahan-li-8")
g_alpha_newmark = Method("g-alpha-newmark")
"""The G^α-Newmark scheme, of linear structures - L of second degree and a force of the time alone - with one fractional term or a material:
of order two, by the weights of bdf2."""
gl_newmark = Method("gl-newmark")
"""The same with the weights of Grünwald and Letnikov: of order one."""


def gauss(nodes: int) -> Method:
    """Galerkin's embedding with 2, 4 or 8 Gauss nodes in a step: of order 4, 8 or 16."""
    return Method(f"gauss-{nodes}")


def theta(lam: float) -> Method:
    """Position and force at (1 - λ) t_i + λ t_{i+1}, 0 < λ < 1: of order one, but for the mid-point."""
    return Method(f"theta:{digits(lam)}")


def two_sided(alpha: float) -> Method:
    """v is the fractional derivative Δ₋^α[q]: the equation ∂L/∂q + Δ₊^α[∂L/∂v] = 0 looks to both ends of T, and is solved from q0 and qN."""
    return Method(f"two-sided:{digits(alpha)}")


@dataclass(frozen=True)
class Force:
    """A force beside dL/dq, a formula for each coordinate."""

    components: tuple

    def _latex(self, L: Lagrangian) -> str:
        made = []
        for f in self.components:
            try:
                made.append(_core.Problem(f, L.coordinates, L.time, L._parameters).written(L.coordinates, L.time, True))
            except _core.NoFormula:
                made.append("\\text{a formula with branches}")
        return made[0] if len(made) == 1 else "(" + ",\\ ".join(made) + ")"


@dataclass(frozen=True)
class Damping:
    """The force -rho D^alpha q on every coordinate, 0 < alpha < 2, read as a mean over each step: of order two under the mid-point
    embedding."""

    rho: float
    alpha: float


@dataclass(frozen=True)
class Zener:
    """The fractional Zener material of a linear structure, whose Lagrangian has the stiffness of the relaxed modulus."""

    relaxed_modulus: float
    unrelaxed_modulus: float
    relaxation_time: float
    alpha: float


def force(*components: "Formula | str") -> Force:
    """force(-v/10), force("-v/10"), or force(f0, f1, ...) with one formula for each coordinate."""
    if len(components) == 1 and not isinstance(components[0], (str, _core.Expression)) and np.ndim(components[0]) > 0:
        components = tuple(np.ravel(components[0]) if isinstance(components[0], np.ndarray) else components[0])
    return Force(tuple(_core.read(f, "the force") if isinstance(f, str) else _core.as_expression(f) for f in components))


def damping(rho: float, alpha: float) -> Damping:
    """Fractional damping with Caputo's derivative, of q - q0 and for alpha > 1 of q - q0 - v0 t; alpha = 1 is friction."""
    return Damping(real(rho, "rho"), real(alpha, "the order alpha"))


def zener(relaxed_modulus: float, unrelaxed_modulus: float, relaxation_time: float, alpha: float) -> Zener:
    """σ + τ^α D^α σ = E₀ ε + E∞ τ^α D^α ε, 0 < α <= 1 and E∞ >= E₀, for g_alpha_newmark and gl_newmark: the Lagrangian of the structure is
    that of the relaxed modulus E₀."""
    names = ("the relaxed modulus", "the unrelaxed modulus", "the relaxation time", "the order alpha")
    return Zener(*map(real, (relaxed_modulus, unrelaxed_modulus, relaxation_time, alpha), names))


@dataclass(frozen=True)
class Equation:
    """The discrete Euler-Lagrange equation of a Lagrangian on a scale; forces, damping and a material are added with +."""

    lagrangian: Lagrangian
    scale: "Uniform | TimeScale"
    method: Method
    forces: "tuple[Force, ...]" = ()
    dampings: "tuple[Damping, ...]" = ()
    material: "Optional[Zener]" = None

    def __add__(self, other: "Force | Damping | Zener") -> "Equation":
        if isinstance(other, Force):
            if len(other.components) != self.lagrangian.dimension:
                raise _core.Mismatch(
                    f"a force has one formula for each coordinate, and here are {len(other.components)} for {self.lagrangian.dimension}"
                )
            made = replace(self, forces=(*self.forces, other))
            made._stated()  # every name in it has a meaning
            return made
        if isinstance(other, Damping):
            return replace(self, dampings=(*self.dampings, other))
        if isinstance(other, Zener):
            if self.material is not None:
                raise _core.InvalidParameter("a structure is of one material, and this one has it already")
            return replace(self, material=other)
        return NotImplemented

    def _stated(self, history: str = "direct") -> "_core.Problem":
        problem = self.lagrangian._problem.copy()
        if self.forces:
            total = list(self.forces[0].components)
            for f in self.forces[1:]:
                total = [a + b for a, b in zip(total, f.components)]
            problem.set_force(total)
        for d in self.dampings:
            problem.add_damping(d.rho, d.alpha)
        if self.material is not None:
            m = self.material
            problem.set_material(m.relaxed_modulus, m.unrelaxed_modulus, m.relaxation_time, m.alpha)
        problem.history = history
        return problem

    def c_code(self, name: str) -> str:
        """One step as C99 that needs math.h alone, of order_one, order_one_left, midpoint, theta and embeddings of operators:
        ``int NAME_step(double h, double q[d], double p[d], double v[d])``, with ``double t`` first where the time is read."""
        return self._stated().c_code(self.method.name, name)

    def _motion(self, history: str = "direct"):
        made = {"double": _core.Motion, "exact": _core.ExactMotion, "50 digits": _core.MotionIn50Digits}[self.scale.kind()]
        return made(self._stated(history), self.method.name, *self._points())

    def _points(self) -> tuple:
        T = self.scale
        number = float if T.kind() == "double" else digits
        return (number(T.start), number(T.step), T.steps) if isinstance(T, Uniform) else ([number(x) for x in T.points],)

    def _written(self, latex: bool) -> str:
        if self.method in (g_alpha_newmark, gl_newmark):
            try:
                return self._motion().equation(latex)
            except _core.InvalidParameter as why:  # what is missing may be added yet
                return f"{self.method.name}: {why}\n"
        undamped = replace(self, dampings=(), forces=(), material=None)
        return undamped._motion().equation(latex)

    def __repr__(self) -> str:
        more = "".join(f"beside ∂L/∂q: {', '.join(map(repr, f.components))}\n" for f in self.forces)
        more += "".join(f"beside ∂L/∂q: −{d.rho} D^{d.alpha} q\n" for d in self.dampings)
        if self.material is not None:
            m = self.material
            more += f"material: E₀ = {m.relaxed_modulus}, E∞ = {m.unrelaxed_modulus}, τ = {m.relaxation_time}, α = {m.alpha}\n"
        return f"{self.lagrangian!r}\n{self._written(False)}{more}"

    def _repr_latex_(self) -> str:
        made = self._written(True)
        lines = [f"L = {self.lagrangian._written(True)}", made if "\\" in made else f"\\text{{{made.strip()}}}"]
        lines += [f"\\text{{beside }} \\partial L/\\partial q:\\ {', '.join(f._latex(self.lagrangian) for f in self.forces)}"] if self.forces else []
        lines += [f"\\text{{beside }} \\partial L/\\partial q:\\ -{d.rho} \\, D^{{{d.alpha}}} q" for d in self.dampings]
        if self.material is not None:
            m = self.material
            lines += [f"E_0 = {m.relaxed_modulus},\\ E_\\infty = {m.unrelaxed_modulus},\\ \\tau = {m.relaxation_time},\\ \\alpha = {m.alpha}"]
        return "$\\displaystyle \\begin{gathered}" + " \\\\ ".join(lines) + "\\end{gathered}$"


def variation(L: Lagrangian, T: "Uniform | TimeScale", method: "Method | str" = midpoint) -> Equation:
    """The variation of the action of L on T under an embedding. It prints as the equation that is solved. An embedding of one's own is made
    of operators, h.embedding(A, B), or is a text, "integral(L((q + sigma[q])/2, Delta_plus[q]))"; parameters of L are known in it."""
    if isinstance(method, str):
        method = Method(method)
    for x, kind, what in (
        (L, Lagrangian, "a Lagrangian"),
        (T, (Uniform, TimeScale), "a scale, as h.uniform(0, 0.1, 100),"),
        (method, Method, "a method, as h.midpoint or h.gauss(4),"),
    ):
        if not isinstance(x, kind):
            raise TypeError(f"{what} was expected, and here is {x!r}")
    _core.require_method(L._problem, method.name, T.kind() == "double")
    return Equation(L, T, method)
