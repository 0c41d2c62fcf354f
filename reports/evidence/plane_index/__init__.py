"""What the index of all scales gives is the static sum, at events, between and beside them, also
where rings touch, and its events are those of the dynamic sum."""
