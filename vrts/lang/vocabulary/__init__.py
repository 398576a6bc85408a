"""Every word of the language: what it is, who knows it, how short it may be."""
