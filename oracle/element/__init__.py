"""The paper's element: every equation from (1) to (22) in exact states, from the field (A.1) and the strain energy."""
