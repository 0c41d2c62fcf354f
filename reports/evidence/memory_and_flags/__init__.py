"""The C++ tests are clean under the sanitizers; what is computed in doubles is right under the
flags that people compile with, or refused; the float filter decides no sign wrongly."""
