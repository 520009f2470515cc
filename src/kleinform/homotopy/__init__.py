"""All solutions of a square polynomial system, by continuation in projective space.

A homotopy H(x, t) = 0 joins a system whose solutions are known, at t = 0, to the wanted one,
at t = 1. The solutions are followed all at once, each with its own t and step: Runge and
Kutta's method of order four predicts, two steps of Newton's method correct, and how far the
first of them goes sets the size of the next step. Points are projective,
``x = (x_0, ..., x_n)`` with the solution ``x_i / x_0``: every step works in the affine chart
that is normal to its own start, so that a path to infinity is a path like any other. Where a
path ends at a singular solution, Newton's method does not; there its end is extrapolated by
powers of ``(1 - t)^(1/w)``, w the number of paths that wind around each other.
"""

from kleinform.homotopy.cones import quadratics, solve_cones
from kleinform.homotopy.endpoints import Endpoints, follow
from kleinform.homotopy.total_degree import solve

__all__ = ["Endpoints", "follow", "quadratics", "solve", "solve_cones"]
