"""Motions beside those of multibody programs that know the mechanism joint by joint."""
