"""Every number that leaves the program, read back from files, tables, documents and arrays by
readers of the judge's own, is right to its last digit against numbers of 1,500 bits."""
