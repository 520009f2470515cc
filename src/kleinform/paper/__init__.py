"""The paper's printed numbers and worked motions beside what kleinform computes."""
