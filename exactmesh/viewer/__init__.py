"""The viewer: a mesh, its claims and its steps in one page that needs no network, and an editor served on loopback."""
