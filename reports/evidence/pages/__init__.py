"""The pages of `minkref view` draw the sum at every scale and radius, copies of a scene follow the
hand at 60 frames a second, and the site of the documentation is built and shown without errors."""
