# SPDX-License-Identifier: BSL-1.0
"""Variational integrators from time-scale calculus: write a Lagrangian, choose the calculus, get the integrator.

    import hilger as h
    q, v = h.variables("q v")
    L = h.Lagrangian(v**2 / 2 - (1 - h.cos(q)), q, v)
    T = h.uniform(0, 0.1, 10_000)
    EL = h.variation(L, T, h.midpoint)
    x = h.solve(EL, q0=1.0, v0=0.0)          # x.t, x.q, x.p
"""

from . import _core
from ._core import (
    Error,
    Expression,
    IllConditioned,
    InvalidInput,
    InvalidParameter,
    InvalidScale,
    Mismatch,
    NoConvergence,
    NoFormula,
    NotFinite,
    Operator,
    OutsideDomain,
    Singular,
    Unreadable,
    where,
)
from .ensemble import Ensemble, solve_many
from .equations import (
    Damping,
    Equation,
    Force,
    Method,
    Zener,
    damping,
    force,
    g_alpha_newmark,
    gauss,
    gl_newmark,
    kahan_li_8,
    lobatto_3,
    methods,
    midpoint,
    order_one,
    order_one_left,
    theta,
    two_sided,
    variation,
    verlet,
    zener,
)
from .formulas import (
    Vector,
    acos,
    acosh,
    asin,
    asinh,
    atan,
    atan2,
    atanh,
    cbrt,
    cos,
    cosh,
    dot,
    erf,
    exp,
    expm1,
    hypot,
    log,
    log1p,
    maximum,
    minimum,
    norm,
    pi,
    read,
    sin,
    sinh,
    sqrt,
    t,
    tan,
    tanh,
    variables,
)
from .lagrangians import Lagrangian, inverse_potential, sundman, transform_time
from .operators import Delta_minus, Delta_plus, adjoint, apply, embedding, identity, rho, sigma
from .scales import Identity, TimeScale, Uniform, identities, uniform
from .solutions import AccurateSolution, DoubtfulSolution, Events, Solution, StepFailure
from .solving import blocks, direct, exponentials, machine_code, solve

__version__ = _core.version
