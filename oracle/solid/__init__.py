"""The pendulum of Table 1 as a plane solid, without a beam's assumptions: by scikit-fem and by CalculiX."""
