"""Values that every package uses: source text, diagnostics, units, numbers and poses."""
