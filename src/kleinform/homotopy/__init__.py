"""All solutions of a square polynomial system, by continuation in projective space.

A homotopy H(x, t) = 0 joins a system whose solutions are known, at t = 0, to the wanted one,
at t = 1. The solutions are followed all at once, each with its own t and step: Runge and
Kutta's method of order four predicts, two steps of Newton's method correct, and how far the
first of them goes sets the size of the next step. Points are projective,
``x = (x_0, ..., x_n)`` with the solution ``x_i / x_0``: every step works in the affine chart
that is normal to its own start, so that a path to infinity is a path like any other. Where a
path ends at a singular solution, or at infinity, Newton's method may not converge; there its
end is the mean over a circle of t around 1, on which w paths wind around each other. A path
ends at infinity where x_0 falls with a positive power of ``1 - t`` from circle to circle.
"""

from kleinform.homotopy.cones import quadratics, solve_cones
from kleinform.homotopy.endpoints import Endpoints, follow
from kleinform.homotopy.total_degree import solve

__all__ = ["Endpoints", "follow", "quadratics", "solve", "solve_cones"]
