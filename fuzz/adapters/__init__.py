"""Programs that let other implementations speak the adapter protocol; start with catalogue.py."""
