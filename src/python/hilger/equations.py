# SPDX-License-Identifier: BSL-1.0
"""Methods, forces and damping, and the discrete Euler-Lagrange equations of Lagrangians with them."""

from __future__ import annotations

import pickle
from dataclasses import dataclass, replace
from typing import Optional

import numpy as np

from . import _core
from .formulas import Formula
from .lagrangians import Lagrangian
from .scales import TimeScale, Uniform, digits, real


@dataclass(frozen=True)
class Method:
    """An embedding, or a composition of steps: its name, or its discrete action, as "integral(L((q + sigma[q])/2, Delta_plus[q]))"."""

    name: str

    def __post_init__(self) -> None:
        if "(" in self.name:
            return  # the equation looks up the names in it
        kinds = {name.split(":")[0] + ":" for name in _core.methods if ":" in name}
        if self.name not in _core.methods and not any(self.name.startswith(kind) for kind in kinds):
            raise _core.InvalidParameter(f"there is no method '{self.name}': there are {', '.join(_core.methods)}")


order_one = Method("order-one")
order_one_left = Method("order-one-left")
midpoint = Method("mid-point")
verlet = Method("verlet")
lobatto_3 = Method("lobatto-3")
kahan_li_8 = Method("kahan-li-8")
"""Seventeen steps of verlet, of order 8 together (Kahan, Li 1997)."""
g_alpha_newmark = Method("g-alpha-newmark")
"""The G^α-Newmark scheme for linear structures (L of second degree, a force of the time alone) with one fractional term or a material: of
order two, by the weights of bdf2, even if the force compares the time and jumps, on a point or within a step."""
gl_newmark = Method("gl-newmark")
"""The same scheme with the weights of Grünwald and Letnikov, of order one."""


def methods() -> None:
    """Print all methods: name, order, definition, and supported number types. variation(L, T, "blanes-moan-4") takes any of these names."""
    print(_core.list_of_methods(), end="")


def gauss(nodes: int) -> Method:
    """Galerkin's embedding with 2, 4, 6 or 8 Gauss nodes in a step: of order 4, 8, 12 or 16. In 50 digits gauss(8) and gauss(16) are
    available, as references."""
    return Method(f"gauss-{nodes}")


def theta(lam: float) -> Method:
    """Position and force at (1 - λ) t_i + λ t_{i+1}, 0 < λ < 1: of order one, except for λ = 1/2 (the mid-point rule)."""
    if not 0 < real(lam, "λ") < 1:
        raise _core.InvalidParameter(f"λ of theta lies between 0 and 1, and here is {lam}; at 0 and 1 it is order_one and order_one_left")
    return Method(f"theta:{digits(lam)}")


def two_sided(alpha: float) -> Method:
    """The two-sided fractional equation ∂L/∂q + Δ₊^α[∂L/∂v] = 0 with v = Δ₋^α[q], a boundary value problem that is solved from q0 and qN."""
    return Method(f"two-sided:{digits(alpha)}")


@dataclass(frozen=True)
class Force:
    """A force beside dL/dq, a formula for each coordinate."""

    components: tuple

    def __eq__(self, other: object) -> bool:
        return pickle.dumps(self) == pickle.dumps(other) if isinstance(other, Force) else NotImplemented

    def __hash__(self) -> int:
        return hash(pickle.dumps(self))

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
    """The force -rho D^alpha q on every coordinate, 0 < alpha < 2: as a mean over each step, of order two, with the mid-point embedding; at the
    nodes of a step, on any T, by the methods radau-3, radau-4 and radau-5."""

    rho: float
    alpha: float


@dataclass(frozen=True)
class Zener:
    """The fractional Zener material of a linear structure, whose Lagrangian has the stiffness of the relaxed modulus. It is unstrained before
    the first point: a q0 other than 0 is a sudden strain, and the stress begins with the unrelaxed modulus."""

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
    made = Damping(real(rho, "rho"), real(alpha, "the order alpha"))
    if not 0 < made.alpha < 2:
        raise _core.InvalidParameter(f"the order alpha lies between 0 and 2, and here is {alpha}")
    return made


def zener(relaxed_modulus: float, unrelaxed_modulus: float, relaxation_time: float, alpha: float) -> Zener:
    """σ + τ^α D^α σ = E₀ ε + E∞ τ^α D^α ε, 0 < α <= 1 and E∞ >= E₀, for g_alpha_newmark and gl_newmark: the Lagrangian of the structure is
    that of the relaxed modulus E₀. A q0 other than 0 is a sudden strain, and σ begins with E∞: relaxed bodies begin at q0 = 0."""
    names = ("the relaxed modulus", "the unrelaxed modulus", "the relaxation time", "the order alpha")
    return Zener(*map(real, (relaxed_modulus, unrelaxed_modulus, relaxation_time, alpha), names))


@dataclass(frozen=True)
class Equation:
    """The discrete Euler-Lagrange equation of a Lagrangian on a scale; forces, damping and a material are added with +.

    Equations of other Lagrangians of the same coordinates on the same scale can be added too: the result is the equation of the sum of the
    actions, each with its own one-step method (order_one, order_one_left, midpoint, theta, embeddings of operators). Forces use the first.
    """

    lagrangian: Lagrangian
    scale: "Uniform | TimeScale"
    method: Method
    forces: "tuple[Force, ...]" = ()
    dampings: "tuple[Damping, ...]" = ()
    material: "Optional[Zener]" = None
    besides: "tuple[tuple[Lagrangian, Method], ...]" = ()

    def __add__(self, other: "Equation | Force | Damping | Zener") -> "Equation":
        if self.lagrangian._rate is not None and isinstance(other, (Equation, Force, Damping, Zener)):
            raise _core.InvalidParameter("a transformed time is for one Lagrangian of constant energy, and nothing is added to its equation")
        if isinstance(other, Equation):
            return self._with(other)
        if self.besides and isinstance(other, (Damping, Zener)):
            raise _core.InvalidParameter("fractional damping is beside one Lagrangian, and this is the equation of several")
        if isinstance(other, Force):
            if len(other.components) != self.lagrangian.dimension:
                raise _core.Mismatch(
                    f"a force has one formula for each coordinate, and here are {len(other.components)} for {self.lagrangian.dimension}"
                )
            made = replace(self, forces=(*self.forces, other))
            made._stated()  # raises for unknown names
            return made
        if isinstance(other, Damping):
            return replace(self, dampings=(*self.dampings, other))
        if isinstance(other, Zener):
            if self.material is not None:
                raise _core.InvalidParameter("a structure is of one material, and this one has it already")
            return replace(self, material=other)
        return NotImplemented

    def __radd__(self, nothing: object) -> "Equation":
        return self if isinstance(nothing, int) and nothing == 0 else NotImplemented  # the start of sum()

    def _with(self, other: "Equation") -> "Equation":
        L, M = self.lagrangian, other.lagrangian
        if (L.coordinates, L.time) != (M.coordinates, M.time):
            raise _core.Mismatch(f"equations add up of the same coordinates, and here are {L.coordinates} and {M.coordinates}")
        if self.scale != other.scale:
            raise _core.Mismatch(f"equations add up on one scale, and here are {self.scale!r} and {other.scale!r}")
        if M._rate is not None or other.forces or other.dampings or other.material is not None or self.dampings or self.material is not None:
            raise _core.InvalidParameter("equations add up without damping and in t, and forces are beside the first one, or added to the sum")
        made = replace(self, besides=(*self.besides, (M, other.method), *other.besides))
        made._motion()  # raises unless every method has one step
        return made

    def _methods(self) -> str:
        return " + ".join((self.method.name, *(method.name for _, method in self.besides)))

    def _stated(self, history: str = "direct") -> "_core.Problem":
        problem = self.lagrangian._problem.copy()
        for L, method in self.besides:
            problem.add(L._problem, method.name)
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
        """One step as C99 that needs only math.h, for order_one, order_one_left, midpoint, theta and embeddings of operators:
        ``int NAME_step(double h, double q[d], double p[d], double v[d])``, with ``double t`` first if the time is used."""
        if not isinstance(name, str):
            raise TypeError(f"C code has a name, a text, and here is {name!r}")
        return self._stated().c_code(self.method.name, name)

    def _motion(self, history: str = "direct"):
        made = {"double": _core.Motion, "exact": _core.ExactMotion, "50 digits": _core.MotionIn50Digits}[self.scale.kind()]
        return made(self._stated(history), self.method.name, self._points())

    def _points(self) -> tuple:
        T = self.scale
        number = float if T.kind() == "double" else digits
        return (number(T.start), number(T.step), T.steps) if isinstance(T, Uniform) else ([number(x) for x in T.points],)

    def _written(self, latex: bool) -> str:
        if self.method in (g_alpha_newmark, gl_newmark):
            try:
                return self._stated().equation(self.method.name, isinstance(self.scale, Uniform), latex)
            except _core.InvalidParameter as why:  # a missing term may still be added
                return f"{self.method.name}: {why}\n"
        undamped = replace(self, dampings=(), forces=(), material=None)
        return undamped._stated().equation(self.method.name, isinstance(self.scale, Uniform), latex)

    def __repr__(self) -> str:
        more = "".join(f"beside ∂L/∂q: {', '.join(map(repr, f.components))}\n" for f in self.forces)
        more += "".join(f"beside ∂L/∂q: −{d.rho} D^{d.alpha} q\n" for d in self.dampings)
        if self.material is not None:
            m = self.material
            more += f"material: E₀ = {m.relaxed_modulus}, E∞ = {m.unrelaxed_modulus}, τ = {m.relaxation_time}, α = {m.alpha}\n"
        written = self._written(False)
        if more and not written.endswith("\n"):  # for methods without an equation
            written += "\n"
        return f"{self._lagrangians(False)}\n{written}{more}"

    def _lagrangians(self, latex: bool) -> str:
        if not self.besides:
            return f"L = {self.lagrangian._written(latex)}{self.lagrangian._rate_written(latex)}"
        name = (lambda k: f"L_{{{k}}}") if latex else (lambda k: "L" + "".join("₀₁₂₃₄₅₆₇₈₉"[int(digit)] for digit in str(k)))
        all_of_them = (self.lagrangian, *(L for L, _ in self.besides))
        return (",\\quad " if latex else ",   ").join(f"{name(k)} = {L._written(latex)}" for k, L in enumerate(all_of_them, 1))

    def _repr_latex_(self) -> str:
        made = self._written(True)
        lines = [self._lagrangians(True), made if "\\" in made else f"\\text{{{made.strip()}}}"]
        lines += [f"\\text{{beside }} \\partial L/\\partial q:\\ {', '.join(f._latex(self.lagrangian) for f in self.forces)}"] if self.forces else []
        lines += [f"\\text{{beside }} \\partial L/\\partial q:\\ -{d.rho} \\, D^{{{d.alpha}}} q" for d in self.dampings]
        if self.material is not None:
            m = self.material
            lines += [f"E_0 = {m.relaxed_modulus},\\ E_\\infty = {m.unrelaxed_modulus},\\ \\tau = {m.relaxation_time},\\ \\alpha = {m.alpha}"]
        return "$\\displaystyle \\begin{gathered}" + " \\\\ ".join(lines) + "\\end{gathered}$"


def variation(L: Lagrangian, T: "Uniform | TimeScale", method: "Method | str" = midpoint) -> Equation:
    """The variation of the action of L on T under an embedding. It prints as the equation that is solved. A user-defined embedding is made of
    operators, h.embedding(A, B), or is a text, "integral(L((q + sigma[q])/2, Delta_plus[q]))", which may use parameters of L."""
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
