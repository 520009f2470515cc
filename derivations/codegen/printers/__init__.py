"""One file a language; each spells the same lowered program."""
