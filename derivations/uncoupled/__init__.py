"""The uncoupled manipulator 3-RPRRC+RRPRU, a file a section of the paper."""
