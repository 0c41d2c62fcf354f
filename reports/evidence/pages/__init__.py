"""The pages of `minkref view` draw the sum at every scale and radius, and the site of the
documentation is built and shown without errors."""
