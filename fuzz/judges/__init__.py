"""The reference before judges that share no code with it (oracle/)."""
