# SPDX-License-Identifier: BSL-1.0
"""Solvers of discrete Euler-Lagrange equations."""

from __future__ import annotations

import os
import re
import warnings
from typing import Callable, Optional, Sequence, Union

import numpy as np

from . import _core
from .equations import Equation, gauss, variation
from .lagrangians import Lagrangian
from .scales import TimeScale, digits, real, require_real, rounds
from .solutions import AccurateSolution, DoubtfulSolution, Solution, StepFailure, Zeros, numbers_from

State = Union[float, Sequence[float], "np.ndarray"]
LONG = 10_000_000  # steps: for more, machine code saves more time than its compilation takes


def direct() -> str:
    """The direct sum over all earlier values: exact, at cost N**2."""
    return "direct"


def blocks() -> str:
    """The same sums by fast convolution, in O(N log(N)**2)."""
    return "blocks"


def exponentials(tolerance: float = 0.0) -> str:
    """The weights as a sum of exponentials, with constant memory. Tolerance 0 means the accuracy of double."""
    return f"exponentials:{tolerance}" if tolerance else "exponentials"


def require_history(history: object) -> None:
    """Raise unless history is one, even if nothing uses it."""
    is_one = isinstance(history, str) and re.fullmatch(r"direct|blocks|exponentials(:[0-9.]+(e-?[0-9]+)?)?", history)
    if not is_one:
        wrong = _core.InvalidParameter if isinstance(history, str) else TypeError
        raise wrong(f"a history is direct(), blocks(), exponentials() or exponentials(1e-8), and not {history!r}")


def _is_list(x: object) -> bool:
    return isinstance(x, (list, tuple)) or np.ndim(x) > 0


def _state(kind: str, x: object, L: Lagrangian, name: str):
    flat = list(x) if _is_list(x) else [x]
    require_real(x, name)
    if L.is_scalar and len(flat) != 1:
        raise _core.Mismatch(f"{name} is one number, and here are {len(flat)}")
    if len(flat) != L.dimension or any(_is_list(y) for y in flat):
        raise _core.Mismatch(f"{name} has {L.dimension} numbers, one for each coordinate, and here is {x!r}")
    if kind == "double":
        return np.array([real(y, f"each component of {name}" if len(flat) > 1 else name) for y in flat])
    if kind == "exact" and any(rounds(y) for y in flat):
        raise _core.InvalidParameter(f"on a scale of fractions {name} is made of fractions or whole numbers, and here is one that rounds")
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
    guess: "Optional[np.ndarray]" = None,
    until: "Optional[Callable]" = None,
    history: str = "exponentials",
    progress: "bool | Callable[[int], None]" = False,
    accuracy: "Optional[float]" = None,
    relative: "Optional[float]" = None,
    longest_step: float = 0.0,
    compiled: "Optional[bool]" = None,
) -> "Solution | AccurateSolution":
    """Solve an equation from q0 and one of v0, p0, q1, or between q0 and qN. The methods order_one, order_one_left, midpoint and theta start
    from q1, without damping. Between two ends Newton's method starts from the straight line, or from `guess`, a row (or a number) for each
    point of T. If there are several solutions it usually finds one near the guess: inspect it, or guess the solution of a similar problem.
    The residual of a returned solution is at most the rounding of the equation's terms. Raises IllConditioned if the ends determine the
    solution to less than half of the digits, as ends half a period of an oscillator apart. Warns with DoubtfulSolution if the solution
    magnifies changes of the ends more than a thousandfold, or differs from the one on every second point by more than any order allows.

    `until=g` ends a walk at the first point of T after a zero of g(t, q, p), as the height of a falling body: x.stopped says so, and
    x.events(g) locates the zero. A bool g is zero where it changes; g = 0 at the start is no zero.

    `history` is the algorithm for fractional damping: direct(), blocks() or exponentials(). `progress=True` shows a bar if tqdm is installed;
    a callable gets the number of steps so far, now and then and at the end. An interrupt (Ctrl-C) ends the walk, and the points so far are
    returned with a warning; between two ends, and to an accuracy, it raises KeyboardInterrupt.

    With a Lagrangian, an interval and an accuracy, solve chooses the method and the scale T: solve(L, (0, 50), q0=1, v0=0, accuracy=1e-10),
    or between two ends solve(L, (0, 1), q0=0, qN=1, accuracy=1e-10). `accuracy` is the largest error of a position, in its unit; `relative` is
    a part of the largest position, instead of it or in addition. From q0 and v0, T follows the motion: its steps are short where the motion is
    fast, and over kinks and jumps of a force. No step is longer than a thirty-second of the interval, or than `longest_step`, which is for
    features so narrow that steps could miss them, as a smooth pulse in time. If the formula compares the time alone, as in
    where(abs(t - 7) < 0.01, 100, 0) or abs(t - pi), the switching times become points of T. They are exact if the comparison is affine in t on
    each side; otherwise, as for sin(t) < 0, two changes within a 4096th of the interval are missed. Between two ends no step is
    longer than a sixteenth of the interval, and steps are short in boundary layers.

    `compiled=True` compiles whole steps to machine code, by the system's C compiler, in some tenths of a second the first time. The conditions
    are those for lanes in solve_many: order_one, order_one_left, midpoint, verlet and kahan_li_8, up to six coordinates in double, no memory,
    no branches, formulas of at most some hundred operations. Steps take the time of the same system in C++, and agree with `compiled=False`
    to rounding. The default is True for ten million steps and more; `x.compiled` tells whether the steps were compiled.

    With the equation of transform_time(L, g) the scale is in τ, and x.t are the times t; it is solved from q0 and v0 or p0, which have its energy.

    Raises StepFailure, whose `solution` has the points so far, and the errors of this module for invalid input.
    """
    if isinstance(equation, Lagrangian):
        if interval is None or (accuracy is None and relative is None) or (v0 is None and qN is None):
            raise _core.InvalidParameter("a Lagrangian is solved over an interval to an accuracy: solve(L, (0, 50), q0=1, v0=0, accuracy=1e-10)")
        if v0 is not None and qN is not None:
            raise _core.InvalidParameter("to an accuracy a Lagrangian is solved from v0 or to qN, and here are both")
        if any(x is not None for x in (p0, q1, guess, until, compiled)) or progress or history != "exponentials":
            raise _core.InvalidParameter("to an accuracy a Lagrangian is solved from q0 and v0, and nothing else is given, or between q0 and qN")
        goal = (0.0 if x is None else real(x, "an accuracy") for x in (accuracy, relative))
        return _solve_accurately(equation, interval, q0, ("v0", v0) if qN is None else ("qN", qN), *goal, real(longest_step, "the longest step"))
    if not isinstance(equation, Equation):
        raise TypeError(f"an equation, as h.variation(L, T, h.midpoint), or a Lagrangian is solved, and not a {type(equation).__name__}")
    require_history(history)
    if not isinstance(compiled, (bool, type(None))):
        raise _core.InvalidParameter(f"compiled is True, False or None, and was {compiled!r}")
    if interval is not None or accuracy is not None or relative is not None:
        raise _core.InvalidParameter("an equation has its scale: an interval and an accuracy go with a Lagrangian")
    given = {name: x for name, x in (("v0", v0), ("p0", p0), ("q1", q1), ("qN", qN)) if x is not None}
    if len(given) != 1:
        raise _core.InvalidParameter(f"q0 and one of v0, p0, q1 and qN determine a solution, and here is q0 with {' and '.join(given) or 'nothing'}")
    (name, other), = given.items()
    kind, L = equation.scale.kind(), equation.lagrangian
    scalar = L.is_scalar
    start = _state(kind, q0, L, "q0"), name, _state(kind, other, L, name)
    if until is not None and (compiled or name == "qN"):
        raise _core.InvalidParameter("until=g ends a walk from initial values, which is asked at each step: not between two ends, and not with compiled=True")
    if compiled is None:
        compiled = until is None and equation.scale.steps >= LONG
    if until is None and name != "qN":
        steps = equation.scale.steps
        require_room((steps + 1) * (1 + 2 * L.dimension), f"the states of {steps} steps", "solve_many(..., every=1000) keeps some of them")
    motion = equation._motion(history)
    column = (lambda x: x[:, 0]) if scalar else (lambda x: x)
    if guess is not None and name != "qN":
        raise _core.InvalidParameter("a guess is for what joins two ends, q0 and qN")
    if name == "qN":
        if guess is not None and not np.iterable(guess):
            raise _core.InvalidParameter(f"a guess has a row, or a number, for each point of T, and here is {guess!r}")
        near = [] if guess is None else [_state(kind, x, L, "each row of the guess") for x in guess]
        if guess is not None and len(near) != equation.scale.steps + 1:
            raise _core.Mismatch(f"a guess has a row for each of the {equation.scale.steps + 1} points of T, and here are {len(near)}")
        *found, doubt = motion.between(start[0], start[2], near)
        q, p = (column(numbers_from(kind, x)) for x in found)
        if doubt:
            warnings.warn(doubt, DoubtfulSolution, stacklevel=2)
        return Solution(equation, (start[0], "q1", _state(kind, q[1], L, "q1")), history, numbers_from(kind, motion.times()), q, p if len(p) else None, None)
    bar = bar_of(progress, equation.scale.steps, " steps")
    made = None
    is_end = _end_of_walk(until, kind, scalar)
    try:
        if compiled and kind == "double":
            made = _core.walk_in_whole_steps(motion, equation._stated(history), equation.method.name, equation._points(), *start, bar)
        t, q, p, stopped, interrupted = made or motion.walk(*start, bar, is_end)
    except _core.Error as why:
        if str(why).startswith("the step from"):
            raise StepFailure(str(why), None) from why
        raise
    finally:
        if hasattr(bar, "close"):
            bar.close()
    x = Solution(equation, start, history, numbers_from(kind, t), column(numbers_from(kind, q)), column(numbers_from(kind, p)), stopped or None)
    x.compiled = made is not None
    if interrupted:
        x.stopped = f"interrupted at t = {x.t[-1]}"
        warnings.warn(x.stopped + "; what there is was kept", RuntimeWarning, stacklevel=2)
    elif stopped:
        raise StepFailure(stopped, x)
    elif is_end is not None and is_end.reached:
        x.stopped = f"`until` passed zero by t = {x.t[-1]}"
    return x


def require_room(numbers: int, what: str, remedy: str) -> None:
    """Raise if so many numbers exceed the memory of the machine."""
    if not hasattr(os, "sysconf"):
        return
    needed, there = 8 * numbers, os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    if needed > there:
        raise _core.InvalidParameter(f"{what} take {needed / 2**30:.3g} GiB or more, and this machine has {there / 2**30:.3g}: {remedy}")


def _solve_accurately(
    L: Lagrangian, interval: object, q0: State, other: "tuple[str, State]", accuracy: float, relative: float, longest_step: float
) -> AccurateSolution:
    if isinstance(interval, str) or np.ndim(interval) != 1 or len(interval) != 2:
        raise _core.InvalidParameter(f"an interval is two numbers, as (0, 50), and here is {interval!r}")
    a, b = (real(x, f"the {end} of an interval") for x, end in zip(interval, ("beginning", "end")))
    name, between = other[0], other[0] == "qN"
    start = _state("double", q0, L, "q0"), name, _state("double", other[1], L, name)
    t, q, p, method, error = _core.solve_accurately(L._problem, a, b, start[0], between, start[2], accuracy, relative, longest_step)
    if between:
        start = start[0], "q1", q[1].copy()
    equation = variation(L, TimeScale(t), gauss(int(re.search("[0-9]+", method)[0])))
    return AccurateSolution(equation, start, t, q[:, 0] if L.is_scalar else q, p[:, 0] if L.is_scalar else p, error)


class _EndOfWalk:
    """Called at each state of a walk in turn: whether g has passed zero since the previous one."""

    def __init__(self, zeros: Zeros) -> None:
        self.zeros, self.was, self.reached = zeros, None, False

    def __call__(self, *made) -> bool:
        now = self.zeros.value(*self.zeros.state(*made))
        self.reached = self.was is not None and self.zeros.passed(self.was, now)
        self.was = now
        return self.reached


def _end_of_walk(until: "Optional[Callable]", kind: str, scalar: bool) -> "Optional[_EndOfWalk]":
    return None if until is None else _EndOfWalk(Zeros(until, kind, scalar, "`until`"))


class _Bar:
    def __init__(self, tqdm, total: int, unit: str) -> None:
        self.bar = tqdm(total=total, unit=unit)

    def __call__(self, reached: int) -> None:
        self.bar.update(reached - self.bar.n)

    def close(self) -> None:
        self.bar.close()


def bar_of(progress: object, total: int, unit: str):
    """The receiver of progress reports, or None."""
    if callable(progress):
        return progress
    if not isinstance(progress, (bool, np.bool_, type(None))):
        raise _core.InvalidParameter(f"progress is True, for a bar, or a function that gets the number of{unit} made, and here is {progress!r}")
    if not progress:
        return None
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return None
    return _Bar(tqdm, total, unit)


def machine_code(how: str = "on") -> None:
    """Set whether formulas become machine code: "on", the default, after 512 or 1024 evaluations, once the system's C compiler has finished; "off";
    or "at once", waiting for the compiler. Results are the same to the last bit.

    The 256 libraries last used are cached in the folder hilger of $XDG_CACHE_HOME or ~/.cache. HILGER_MACHINE_CODE=off in the environment
    sets "off".
    """
    if not isinstance(how, str):
        raise TypeError(f'machine code is "on", "off" or "at once", and here is {how!r}')
    _core.set_machine_code(how)
