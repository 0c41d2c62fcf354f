"""What the evidence scripts share: what a part is, where results are kept, how they are shown."""
