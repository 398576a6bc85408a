"""The contract between language and engine: a program with no language and no robot question open."""
