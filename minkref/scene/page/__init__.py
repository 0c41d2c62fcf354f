"""A scene's page: drag and scale copies, see free space change."""
