"""The paper on trial: what Behar & Lien 2012 says, what holds, and a check behind every entry."""
