"""Libraries on trial: a folder for each, with its adapters and the program that shows a fault."""
