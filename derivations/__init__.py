"""Build time only: derives, proves and generates. Nothing here is imported at run time."""
