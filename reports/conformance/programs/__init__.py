"""Stand-alone programs that show a finding with the accused library alone."""
