"""A verified program on its way to a real controller: plan, bundle, transfer, other dialects."""
