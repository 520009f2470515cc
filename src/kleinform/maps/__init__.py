"""Maps of where limits hold."""
