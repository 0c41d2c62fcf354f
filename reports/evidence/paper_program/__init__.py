"""The paper's update (Behar & Lien 2012, Section 4), followed formula by formula in rational
numbers, doubles and MPFR: with all formulas corrected it is the exact sum in rational numbers; how
often each formula as printed, and each arithmetic, is right."""
