"""Points, predicates and squared distances over the rationals: part of the trusted kernel."""
