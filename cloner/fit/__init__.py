"""The one fit: named parameter blocks with priors, residuals with Jacobians, robust Gauss-Newton, covariances."""
