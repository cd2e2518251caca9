"""The steps of the constructions, each a module with its checker beside it, and the records they share."""
