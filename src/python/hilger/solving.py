# SPDX-License-Identifier: BSL-1.0
"""Solutions of discrete Euler-Lagrange equations."""

from __future__ import annotations

import contextlib
import warnings
from fractions import Fraction
from typing import Callable, NamedTuple, Optional, Sequence, Union

import numpy as np

from . import _core
from .equations import Equation, Lagrangian
from .scales import digits

State = Union[float, Sequence[float], "np.ndarray"]


class StepFailure(_core.Error):
    """A step failed. What was reached before is in `solution`; None where the first step could not begin."""

    def __init__(self, message: str, solution: "Solution") -> None:
        super().__init__(message)
        self.solution = solution


def direct() -> str:
    """The sum over all that was: exact, and of cost N**2."""
    return "direct"


def blocks() -> str:
    """The same sums by fast convolutions in O(N log(N)**2)."""
    return "blocks"


def exponentials(tolerance: float = 0.0) -> str:
    """The weights as a sum of exponentials: constant memory. With tolerance 0 as exact as double is."""
    return f"exponentials:{tolerance}" if tolerance else "exponentials"


def _digits_of(kind: str):
    """What a scalar computes with where Python computes with it."""
    if kind != "50 digits":
        return contextlib.nullcontext()
    import mpmath

    return mpmath.workdps(60)


def _numbers(kind: str, made: object) -> np.ndarray:
    """What came from the engine, as an array: of Fraction or mpf for scalars that numpy does not have."""
    if kind == "double":
        return made
    words, columns = made
    if kind == "exact":
        all_of_them = [Fraction(x) for x in words]
    else:
        import mpmath

        with _digits_of(kind):
            all_of_them = [mpmath.mpf(x) for x in words]
    array = np.array(all_of_them, dtype=object)
    return array.reshape(-1, columns) if columns else array


class Events(NamedTuple):
    """Where a function of the state passes zero: times t, positions q and momenta p, one row for each event."""

    t: np.ndarray
    q: np.ndarray
    p: np.ndarray


class Solution:
    """A trajectory: points t, positions q and momenta p, one row for each point (one number where there is one coordinate).

    `x(t)` is q between the points, of order 4 in the step; `x.events(g)` where a function passes zero; `x.residual()` what the positions
    leave of their equation; `x.energy()` H at the points; `x.stopped` says why a trajectory ended before its scale did. What joins two ends
    has positions alone, and p is None. It can be pickled; it goes on where it ends with h.solve(later, q0=x.q[-1], p0=x.p[-1]).
    """

    def __init__(self, equation: Equation, start: tuple, history: str, t, q, p, stopped: "Optional[str]") -> None:
        self.equation, self._start, self._history = equation, start, history
        self.t, self.q, self.p, self.stopped = t, q, p, stopped
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
        return f"<{self.equation.method.name}, {len(self)} points from t = {self.t[0]} to {self.t[-1]}{end}>"

    def _momenta(self):
        if self.p is None:
            raise _core.InvalidParameter("what joins two ends has positions alone; solve again from q0 and q1 for momenta")
        return self.p

    def _row(self, x: np.ndarray, i: int):
        return np.atleast_1d(x[i]) if self.t.dtype != object else [digits(y) for y in np.atleast_1d(x[i])]

    def _time(self, t: object):
        return float(t) if self.t.dtype != object else digits(t)

    def __call__(self, t: "float | Sequence[float]"):
        """q at t, a number or an array of them. @raises OutsideDomain"""
        if np.ndim(t) > 0:
            return np.array([self(s) for s in t])
        p = self._momenta()
        if not self.t[0] <= t <= self.t[-1]:
            raise _core.OutsideDomain(f"t = {t} is outside of the solution, which goes from {self.t[0]} to {self.t[-1]}")
        if len(self) == 1:
            return self.q[0]
        i = min(max(int(np.searchsorted(self.t, t, side="right")) - 1, 0), len(self) - 2)
        row, time = self._row, self._time
        ends = (z for j in (i, i + 1) for z in (time(self.t[j]), row(self.q, j), row(p, j)))
        q, _ = self._motion.between_states(*ends, time(t))
        kind = self.equation.scale.kind()
        q = _numbers(kind, q)
        return q[0] if self.q.ndim == 1 else q

    def events(self, g: Callable, crossing: str = "any") -> Events:
        """Where g(t, q, p) passes zero, as in Poincaré sections: located between the points, on what x(t) is, to the last digits.

        `crossing` is "any", "rising" or "falling". g = 0 at the start is no event, and two within one step are not seen.
        """
        if crossing not in ("any", "rising", "falling"):
            raise _core.InvalidParameter(f'crossing is "any", "rising" or "falling", and not {crossing!r}')
        p, kind, row, scalar = self._momenta(), self.equation.scale.kind(), self._row, self.q.ndim == 1

        def value(t, q, p):
            with _digits_of(kind):
                y = g(t, q, p)
            if not y - y == 0:
                raise _core.NotFinite(f"the function whose zeros are events is {y} at t = {t}")
            return y

        def state(made):
            t, q, p = made
            q, p = _numbers(kind, q), _numbers(kind, p)
            return (_one(kind, t), q[0], p[0]) if scalar else (_one(kind, t), q, p)

        found = []
        was = value(self.t[0], self.q[0], p[0])
        for i in range(1, len(self)):
            now = value(self.t[i], self.q[i], p[i])
            if (was < 0 <= now and crossing != "falling") or (was > 0 >= now and crossing != "rising"):
                ends = (z for j in (i - 1, i) for z in (self._time(self.t[j]), row(self.q, j), row(p, j)))
                found.append(state(self._motion.zero_between(*ends, lambda *made: self._time(value(*state(made))))))
            was = now
        t, q, momenta = zip(*found) if found else ((), (), ())
        empty = self.q[:0]
        return Events(np.array(t, dtype=self.t.dtype), np.array(q) if found else empty, np.array(momenta) if found else empty)

    def residual(self):
        """The largest component of what the positions leave of their discrete Euler-Lagrange equation, of the size of rounding."""
        if self.stopped:
            raise _core.InvalidParameter(f"the residual is that of a whole solution, and this one stopped: {self.stopped}")
        positions = [self._row(self.q, i) for i in range(len(self))]
        return _one(self.equation.scale.kind(), self._motion.residual(*self._start, positions))

    def energy(self) -> np.ndarray:
        """H = p v - L at each point."""
        row, kind, p = self._row, self.equation.scale.kind(), self._momenta()
        return np.array([_one(kind, self._motion.energy(self._time(t), row(self.q, i), row(p, i))) for i, t in enumerate(self.t)])

    def plot(self, ax=None, **style):
        """Positions over time, by matplotlib. Returns the axes."""
        if ax is None:
            import matplotlib.pyplot as plt

            _, ax = plt.subplots()
        ax.plot(self.t, self.q, **style)
        ax.set_xlabel("t")
        ax.set_ylabel("q")
        return ax

    def plot_energy_error(self, ax=None, **style):
        """H(t) - H(0), by matplotlib. Returns the axes."""
        if ax is None:
            import matplotlib.pyplot as plt

            _, ax = plt.subplots()
        H = self.energy()
        ax.plot(self.t, H - H[0], **style)
        ax.set_xlabel("t")
        ax.set_ylabel("H − H(0)")
        return ax


class AccurateSolution:
    """A solution to a wanted accuracy: t, q, the method that was chosen, and `error`, its distance from the run with half as many steps.

    That is more than its own error where L is smooth; where L has branches it is twice the largest distance from three other runs.
    """

    def __init__(self, t, q, end_momentum, method: str, error: float) -> None:
        self.t, self.q, self.end_momentum, self.method, self.error = t, q, end_momentum, method, error

    def __repr__(self) -> str:
        return f"<{self.method}, {len(self.t) - 1} steps, {self.error:.1e} from half as many>"


def _one(kind: str, made: object):
    return made if kind == "double" else _numbers(kind, ([made], 0))[0]


def _state(kind: str, x: object, L: Lagrangian, name: str):
    flat = [x] if np.ndim(x) == 0 else list(x)
    if L.is_scalar and len(flat) != 1:
        raise _core.Mismatch(f"{name} is one number, and here are {len(flat)}")
    if len(flat) != L.dimension or any(np.ndim(y) > 0 for y in flat):
        raise _core.Mismatch(f"{name} has {L.dimension} numbers, one for each coordinate, and here is {x!r}")
    if kind == "double":
        return np.array([float(y) for y in flat])
    if kind == "exact" and any(isinstance(y, float) for y in flat):
        raise _core.InvalidParameter(f"on a scale of fractions {name} is made of fractions or whole numbers, and here is a float")
    return [digits(y) for y in flat]


def solve(
    equation: "Equation | Lagrangian",
    interval: "Optional[tuple[float, float]]" = None,
    *,
    q0: State,
    v0: "Optional[State]" = None,
    p0: "Optional[State]" = None,
    q1: "Optional[State]" = None,
    qN: "Optional[State]" = None,
    history: str = "exponentials",
    progress: "bool | Callable[[int], None]" = False,
    accuracy: "Optional[float]" = None,
    longest_step: float = 0.0,
) -> "Solution | AccurateSolution":
    """Solve an equation from q0 and one of v0, p0, q1, or between q0 and qN.

    `history` is what fractional damping remembers with: direct(), blocks() or exponentials(). `progress=True` shows a bar where tqdm is
    installed; a callable gets the number of points. An interrupt (Ctrl-C) ends the walk, and what there is is returned with a warning.
    With a Lagrangian, an interval and an accuracy the method and the number of steps are found: solve(L, (0, 50), q0=1, v0=0,
    accuracy=1e-10). `longest_step` is for what is narrow, as a pulse in time: steps that are all longer may miss it.

    Raises StepFailure, whose `solution` has what was reached, and the errors of this module for input that has no meaning.
    """
    if isinstance(equation, Lagrangian):
        if interval is None or accuracy is None or v0 is None:
            raise _core.InvalidParameter("a Lagrangian is solved over an interval to an accuracy: solve(L, (0, 50), q0=1, v0=0, accuracy=1e-10)")
        if any(x is not None for x in (p0, q1, qN)) or progress or history != "exponentials":
            raise _core.InvalidParameter("to an accuracy a Lagrangian is solved from q0 and v0, and nothing else is given")
        a, b = interval
        scalar = equation.is_scalar
        made = _core.solve_accurately(
            equation._problem, float(a), float(b), _state("double", q0, equation, "q0"), _state("double", v0, equation, "v0"), float(accuracy), float(longest_step)
        )
        t, q, p, method, error = made
        return AccurateSolution(t, q[:, 0] if scalar else q, p, method, error)
    if not isinstance(equation, Equation):
        raise TypeError(f"an equation, as h.variation(L, T, h.midpoint), or a Lagrangian is solved, and not a {type(equation).__name__}")
    if not isinstance(history, str):
        raise TypeError(f"a history is direct(), blocks() or exponentials(), and not {history!r}")
    if interval is not None or accuracy is not None:
        raise _core.InvalidParameter("an equation has its scale: an interval and an accuracy go with a Lagrangian")
    given = {name: x for name, x in (("v0", v0), ("p0", p0), ("q1", q1), ("qN", qN)) if x is not None}
    if len(given) != 1:
        raise _core.InvalidParameter(f"q0 and one of v0, p0, q1 and qN determine a solution, and here is q0 with {' and '.join(given) or 'nothing'}")
    (name, other), = given.items()
    kind, L = equation.scale.kind(), equation.lagrangian
    scalar = L.is_scalar
    start = _state(kind, q0, L, "q0"), name, _state(kind, other, L, name)
    motion = equation._motion(history)
    column = (lambda x: x[:, 0]) if scalar else (lambda x: x)
    if name == "qN":
        q = column(_numbers(kind, motion.between(start[0], start[2])))
        return Solution(equation, (start[0], "q1", _state(kind, q[1], L, "q1")), history, _numbers(kind, motion.times()), q, None, None)
    bar = _bar(progress, equation)
    try:
        t, q, p, stopped, interrupted = motion.walk(*start, bar)
    except _core.Error as why:
        if str(why).startswith("the step from"):
            raise StepFailure(str(why), None) from why
        raise
    finally:
        if hasattr(bar, "close"):
            bar.close()
    x = Solution(equation, start, history, _numbers(kind, t), column(_numbers(kind, q)), column(_numbers(kind, p)), stopped or None)
    if interrupted:
        x.stopped = f"interrupted at t = {x.t[-1]}"
        warnings.warn(x.stopped + "; what there is was kept", RuntimeWarning, stacklevel=2)
    elif stopped:
        raise StepFailure(stopped, x)
    return x


class _Bar:
    def __init__(self, tqdm, total: int) -> None:
        self.bar = tqdm(total=total, unit=" steps")

    def __call__(self, reached: int) -> None:
        self.bar.update(reached - self.bar.n)

    def close(self) -> None:
        self.bar.close()


def _bar(progress: object, equation: Equation):
    if callable(progress):
        return progress
    if not progress:
        return None
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return None
    return _Bar(tqdm, equation.scale.steps)


def machine_code(how: str = "on") -> None:
    """Whether formulas become machine code: "on", as it is, once they have been evaluated a thousand times and the system's C compiler is
    ready with them; "off"; or "at once", waiting for the compiler. Results are the same to the last bit.

    What is compiled is kept in the folder hilger of $XDG_CACHE_HOME or ~/.cache. HILGER_MACHINE_CODE=off in the environment says "off".
    """
    _core.set_machine_code(how)
