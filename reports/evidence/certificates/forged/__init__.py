"""Forged certificates: true ones from the commands, changed so that all figures agree with a
lie. Written from the pages docs/certificates*.md alone, without a look at any checker."""
