"""Values that every package uses: source text, diagnostics, units, numbers and poses.

In and out: plain values. Knows nothing else of vrts, and no library beside the standard one.
"""
