"""What people look at: the conformance report and the evidence."""
