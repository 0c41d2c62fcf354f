"""The tables, figures and times of Behar & Lien 2012 beside ours."""
