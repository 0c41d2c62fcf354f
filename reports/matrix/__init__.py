"""The matrix: how libraries answered the families of one kept run of `minkref verify`."""
