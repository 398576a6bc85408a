"""VAL-II text to IR: splitter, tokeniser, grammar, vocabulary, resolution and lowering."""
