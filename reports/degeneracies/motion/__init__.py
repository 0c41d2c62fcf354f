"""Pages of families: what is drawn and told of their cases."""
