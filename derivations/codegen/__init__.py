"""From named equations to source text: kernels, lowering, printers, the written tree."""
