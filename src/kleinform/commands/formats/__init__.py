"""Tables as CSV, JSON and NPZ, read and written in blocks."""
