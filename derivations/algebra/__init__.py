"""Algebra of any mechanism: vectors, screws, graphs of equations, identities."""
