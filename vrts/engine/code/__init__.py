"""The IR made ready to run: instructions and expressions as closures over the machine's state."""
