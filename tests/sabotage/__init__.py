"""One-line patches of the product, each of which must make the suite fail."""
