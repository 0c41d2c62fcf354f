"""Hostile arguments, files and operands end in a value or a refusal, never in a crash, and long
lists take bounded time and memory."""
