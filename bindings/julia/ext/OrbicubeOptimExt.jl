"""
The methods of Orbicube in `Optim.optimize`. Julia 1.9 and later load this where both packages are loaded.
"""
module OrbicubeOptimExt

import Optim, Orbicube

Optim.optimize(f, x0::AbstractArray, method::Orbicube.Method; problem...) = Orbicube.optimize(f, x0, method; problem...)
Optim.optimize(f, g!, x0::AbstractArray, method::Orbicube.Method; problem...) = Orbicube.optimize(f, g!, x0, method; problem...)
Optim.optimize(f, lower::AbstractVector, upper::AbstractVector, x0::AbstractVector, method::Orbicube.Method; problem...) =
    Orbicube.optimize(f, lower, upper, x0, method; problem...)
Optim.optimize(f, g!, lower::AbstractVector, upper::AbstractVector, x0::AbstractVector, method::Orbicube.Method; problem...) =
    Orbicube.optimize(f, g!, lower, upper, x0, method; problem...)

# Queries of a result, beside Base.minimum.
Optim.minimizer(result::Orbicube.Result) = Orbicube.minimizer(result)
Optim.converged(result::Orbicube.Result) = Orbicube.converged(result)
Optim.iterations(result::Orbicube.Result) = Orbicube.iterations(result)
Optim.f_calls(result::Orbicube.Result) = Orbicube.f_calls(result)

end
