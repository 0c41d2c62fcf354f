"""An addition touches the files that its recipe in CONTRIBUTING names, and works."""
