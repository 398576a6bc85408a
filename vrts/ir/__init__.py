"""The contract between language and engine: programs with no language question left open."""
