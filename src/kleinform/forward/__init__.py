"""The forward displacement: every assembly mode of given joint values."""
