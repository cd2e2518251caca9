"""What exactness costs: time and memory of every stage against the number of vertices, and beside other programs."""
