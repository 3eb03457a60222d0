# SPDX-License-Identifier: BSL-1.0
"""Solutions: positions and momenta at the points of a scale, with dense output, events, residuals and energies."""

from __future__ import annotations

import contextlib
from dataclasses import replace
from fractions import Fraction
from typing import Callable, NamedTuple, Optional, Sequence

import numpy as np

from . import _core
from .equations import Equation
from .scales import TimeScale, Uniform, digits, fraction_from, real


class StepFailure(_core.Error):
    """A step failed. `solution` has the points before it; None if the first step could not begin."""

    def __init__(self, message: str, solution: "Solution") -> None:
        super().__init__(message)
        self.solution = solution

    def __reduce__(self) -> tuple:
        return StepFailure, (*self.args, self.solution)


def digits_of(kind: str):
    """A context in which Python computes with the digits of a scalar."""
    if kind != "50 digits":
        return contextlib.nullcontext()
    import mpmath

    return mpmath.workdps(60)


def numbers_from(kind: str, made: object) -> np.ndarray:
    """Numbers from the engine as an array, of Fraction or mpf for scalars that numpy does not have."""
    if kind == "double":
        return made
    words, columns = made
    if kind == "exact":
        all_of_them = [fraction_from(x) for x in words]
    else:
        import mpmath

        with digits_of(kind):
            all_of_them = [mpmath.mpf(x) for x in words]
    array = np.array(all_of_them, dtype=object)
    return array.reshape(-1, columns) if columns else array


def number_from(kind: str, made: object):
    return made if kind == "double" else numbers_from(kind, ([made], 0))[0]


class DoubtfulSolution(RuntimeWarning):
    """A solution between two ends that is sensitive to them, or differs on fewer points: it may be near no motion."""


class Events(NamedTuple):
    """The zeros of a function of the state: times t, positions q and momenta p, one row for each event."""

    t: np.ndarray
    q: np.ndarray
    p: np.ndarray


class Zeros:
    """The values of a function g(t, q, p) along a walk in scalars of a kind, and whether it passed zero between two of them."""

    def __init__(self, g: Callable, kind: str, scalar: bool, name: str) -> None:
        if not callable(g):
            raise _core.InvalidParameter(f"{name} is a function of t, q and p, and here is {g!r}")
        self.g, self.kind, self.scalar = g, kind, scalar

    def value(self, t, q, p, inside: bool = False):
        with digits_of(self.kind):
            y = self.g(t, q, p)
            if isinstance(y, (bool, np.bool_)):
                return 1 if y else -1
            if y is None or isinstance(y, (str, bytes)) or np.ndim(y) > 0 or np.iscomplexobj(y):
                raise _core.InvalidParameter(f"a function whose zeros are events returns a real number, or a bool, and at t = {t} it is {y!r}")
        if inside and abs(y) == float("inf"):
            return np.finfo(float).max if y > 0 else -np.finfo(float).max  # at a pole, keeping the sign
        with np.errstate(invalid="ignore"):
            finite = y - y == 0
        if not finite:
            raise _core.NotFinite(f"the function whose zeros are events is {y} at t = {t}")
        return y

    def state(self, t, q, p):
        """A state from the engine's numbers."""
        t, q, p = number_from(self.kind, t), numbers_from(self.kind, q), numbers_from(self.kind, p)
        return (t, q[0], p[0]) if self.scalar else (t, q, p)

    @staticmethod
    def passed(was, now, crossing: str = "any") -> bool:
        return (was < 0 <= now and crossing != "falling") or (was > 0 >= now and crossing != "rising")

    @staticmethod
    def come_near(values: list, i: int) -> bool:
        """Whether values at points are nearer to zero at an end of step i than their second differences there: it may have two zeros."""
        bends = (abs(values[j - 1] - 2 * values[j] + values[j + 1]) for j in (i, i + 1) if 0 < j < len(values) - 1)
        return min(abs(values[i]), abs(values[i + 1])) < max(bends, default=0)


class Solution:
    """A trajectory: points t, positions q and momenta p, one row for each point (one number for a scalar coordinate).

    `x(t)` is q between the points, as accurate as at them, by a step of the method from the point before: with fractional damping, whose
    memory is no part of a state, there is none. `x.events(g)` are the zeros of a function, as accurate; `x.residual()` the residual of the
    equation, in roundings of its terms; `x.energy()` H at the points; `x.stopped` the reason why a trajectory ended before its scale,
    `x.compiled` whether whole steps were machine code. The solution of a two-sided fractional equation has positions alone, and p is None. It
    can be pickled. h.solve(later, q0=x.q[-1], p0=x.p[-1]) continues it, unless there is fractional damping.

    Momenta are those of the discrete Legendre map, p_i = -dL_h/dq_i of the step that begins at t_i. A printed Hamiltonian system has dL/dv
    at the nodes of the embedding instead: for order_one its p at t_i is x.p at t_{i+1}.
    """

    def __init__(self, equation: Equation, start: tuple, history: str, t, q, p, stopped: "Optional[str]") -> None:
        self.equation, self._start, self._history = equation, start, history
        self.t, self.q, self.p, self.stopped = t, q, p, stopped
        self.compiled = False
        self._made = None

    def __getstate__(self) -> dict:
        return {**self.__dict__, "_made": None}

    @property
    def _motion(self):
        if self._made is None:
            self._made = self.equation._motion(self._history)
        return self._made

    def __len__(self) -> int:
        return len(self.t)

    def __repr__(self) -> str:
        end = f", stopped: {self.stopped}" if self.stopped else ""
        return f"<{self.equation._methods()}, {len(self)} points from t = {self.t[0]} to {self.t[-1]}{end}>"

    def _momenta(self):
        if self.p is None:
            raise _core.InvalidParameter("the solution of a two-sided fractional equation has positions alone, and this needs momenta")
        return self.p

    def _row(self, x: np.ndarray, i: int):
        return np.atleast_1d(x[i]) if self.t.dtype != object else [digits(y) for y in np.atleast_1d(x[i])]

    def _time(self, t: object):
        return float(t) if self.t.dtype != object else digits(t)

    def _given_time(self, t: object):
        kind = self.equation.scale.kind()
        if kind == "double":
            return real(t, "a time")
        if kind == "exact" and not isinstance(t, (int, np.integer, Fraction, str)):
            raise _core.InvalidParameter(f"a time on a scale of fractions is one, or a whole number, and here is {t!r}")
        return number_from(kind, digits(t))

    def __call__(self, t: "float | Sequence[float]"):
        """q at t, a number or an array of them. @raises OutsideDomain"""
        if np.ndim(t) > 0:
            return np.array([self(s) for s in t])
        p, t = self._momenta(), self._given_time(t)
        if not self.t[0] <= t <= self.t[-1]:
            raise _core.OutsideDomain(f"t = {t} is outside of the solution, which goes from {self.t[0]} to {self.t[-1]}")
        if len(self) == 1:
            return self.q[0]
        i = min(max(int(np.searchsorted(self.t, t, side="right")) - 1, 0), len(self) - 2)
        q = numbers_from(self.equation.scale.kind(), self._inside(i, t)[0])
        return q[0] if self.q.ndim == 1 else q

    def _inside(self, i: int, t):
        """q and p at t between the points i and i + 1, as numbers of the engine."""
        row, time = self._row, self._time
        ends = (z for j in (i, i + 1) for z in (time(self.t[j]), row(self.q, j), row(self.p, j)))
        return self._motion.between_states(*ends, time(t))

    def events(self, g: Callable, crossing: str = "any") -> Events:
        """The zeros of g(t, q, p), as in Poincaré sections, located to the last digits on x(t), so as accurate as the points.

        `crossing` is "any", "rising" or "falling". g = 0 at the start is no event. Two zeros within one step are missed. In a solution to an
        accuracy, g is evaluated at the eighths of a step, too, where its values at the ends are nearer to zero than its second differences:
        two zeros are missed within an eighth. A pole, with |g| larger than at both ends of its step, is no event. A bool g is zero where it
        changes.
        """
        if crossing not in ("any", "rising", "falling"):
            raise _core.InvalidParameter(f'crossing is "any", "rising" or "falling", and not {crossing!r}')
        zeros = Zeros(g, self.equation.scale.kind(), self.q.ndim == 1, "what passes zero")
        points = list(zip(self.t, self.q, self._momenta()))
        values = [zeros.value(*x) for x in points]
        found = []
        for i in range(len(self) - 1):
            if not zeros.passed(values[i], values[i + 1]) and (self._looks == 1 or not zeros.come_near(values, i)):
                continue
            last, was = points[i], values[i]
            start, step = self.t[i], self.t[i + 1] - self.t[i]
            inside = (self._state(zeros, i, start + k * step / self._looks) for k in range(1, self._looks))
            for state in (*inside, points[i + 1]):
                now = zeros.value(*state)
                if zeros.passed(was, now, crossing):
                    zero = self._zero(zeros, i, last, state, was, now)
                    if abs(zeros.value(*zero, inside=True)) <= max(abs(was), abs(now)):
                        found.append(zero)
                last, was = state, now
        t, q, momenta = zip(*found) if found else ((), (), ())
        empty = self.q[:0]
        return Events(np.array(t, dtype=self.t.dtype), np.array(q) if found else empty, np.array(momenta) if found else empty)

    def _state(self, zeros: Zeros, i: int, t):
        return zeros.state(self._time(t), *self._inside(i, t))

    def _zero(self, zeros: Zeros, i: int, first: tuple, last: tuple, was, now) -> tuple:
        """The first state at or after the zero of g between two states of step i with the values `was` and `now`."""

        def at(fraction):
            with digits_of(zeros.kind):
                t = first[0] + number_from(zeros.kind, fraction) * (last[0] - first[0])
            return self._state(zeros, i, t)

        stays = now == 0  # finds the first zero

        def g(fraction):
            y = zeros.value(*at(fraction), inside=True)
            return self._time(-was if stays and y == 0 else y)

        fraction = self._motion.fraction_at_zero(g, self._time(was), self._time(-was if stays else now))
        return last if number_from(zeros.kind, fraction) == 1 else at(fraction)

    #: Parts of a step, at whose ends events are checked where they come near.
    _looks = 1

    def residual(self, absolute: bool = False):
        """The largest residual of the discrete Euler-Lagrange equation at the positions, each row divided by its rounding: by epsilon times
        the sum of the sizes of its terms. It has no unit, and is at most some tens for a solution, with any steps. For exact fractions the
        divisor is the sum of the sizes alone. `absolute=True` gives it in the units of the equation, where it grows as epsilon / h**2. For a
        stopped solution it covers the points that exist.

        For compositions, as verlet and kahan_li_8, it is the residual of their parts at positions and momenta. Newmark's schemes have no such
        equation, and raise InvalidParameter.
        """
        if len(self) < 2:
            raise _core.InvalidParameter("the residual is that of two points and more, and this solution has one")
        positions, momenta = ([self._row(x, i) for i in range(len(self))] if x is not None else [] for x in (self.q, self.p))
        motion = self._motion if len(self) == self.equation.scale.steps + 1 else self._reached()._motion(self._history)
        return number_from(self.equation.scale.kind(), motion.residual(*self._start, positions, momenta, bool(absolute)))

    def _reached(self) -> Equation:
        """The equation of a stopped solution, on its part of the scale."""
        T = self.equation.scale
        return replace(self.equation, scale=Uniform(T.start, T.step, len(self) - 1) if isinstance(T, Uniform) else TimeScale(T.points[: len(self)]))

    def energy(self) -> np.ndarray:
        """H = p v - L at each point."""
        row, kind, p = self._row, self.equation.scale.kind(), self._momenta()
        with digits_of(kind):
            mean = self._mean_velocities()
        return np.array([number_from(kind, self._motion.energy(self._time(t), *(row(x, i) for x in (self.q, p, mean)))) for i, t in enumerate(self.t)])

    def _mean_velocities(self):
        """The mean velocity of the step after each point, of the last step at the last one: selects among velocities of equal momentum."""
        if len(self) == 1:
            return np.zeros_like(self.q)
        h = np.diff(self.t)
        mean = np.diff(self.q, axis=0) / (h if self.q.ndim == 1 else h[:, None])
        return np.concatenate([mean, mean[-1:]])

    def plot(self, ax=None, **style):
        """Positions over time, by matplotlib. Returns the axes."""
        ax = _axes(ax, "q")
        ax.plot(self.t, self.q, **style)
        return ax

    def plot_energy_error(self, ax=None, **style):
        """H(t) - H(0), by matplotlib. Returns the axes."""
        ax, H = _axes(ax, "H − H(0)"), self.energy()
        ax.plot(self.t, H - H[0], **style)
        return ax

    def plot_steps(self, ax=None, **style):
        """The lengths of the steps over time, each constant along its step and on a logarithmic axis, by matplotlib. Returns the axes."""
        ax = _axes(ax, "length of the step")
        ax.plot(np.repeat(self.t, 2)[1:-1], np.repeat(np.diff(self.t), 2), **style)
        ax.set_yscale("log")
        return ax


def _axes(ax, label: str):
    """The given axes, or new ones, over time."""
    if ax is None:
        import matplotlib.pyplot as plt

        _, ax = plt.subplots()
    ax.set_xlabel("t")
    ax.set_ylabel(label)
    return ax


class AccurateSolution(Solution):
    """A solution to a requested accuracy. `method` and the scale `equation.scale` were chosen for it. `error` estimates the largest error of q.

    From initial values it is the distance of q from a walk in longer steps: for smooth L more than its own error, and at least the rounding
    shared by both, or the accuracy if all positions are 0. For L with branches it is four times that distance. Times at which L switches are
    points of the scale. Between two ends it is the distance from the solution on the scale with pairs of steps joined.
    """

    _looks = 8  # steps are long

    def __init__(self, equation: Equation, start: tuple, t, q, p, error: float) -> None:
        super().__init__(equation, start, "exponentials", t, q, p, None)
        self.error = error

    @property
    def method(self) -> str:
        return self.equation.method.name

    def __repr__(self) -> str:
        return f"<{self.method}, {len(self) - 1} steps, error {self.error:.1e}>"
